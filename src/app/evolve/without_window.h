#pragma once

#include "app/process/exit_status.h"
#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// The studio subcommand where no window can be opened. It prints the reason and, if settings are
// given, runs the evolution without a window.
class WithoutWindow {
public:
    void add_options(CLI::App& app);
    const std::string& settings_file() const { return settings_; }  // empty if none is given
    ExitStatus run(const Error& reason, const EvolutionKinds& kinds) const;

private:
    std::string settings_;
};

}  // namespace cambrian
