#pragma once

#include "app/process/exit_status.h"
#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// What the studio does where no window can be opened: it says why and, if settings are given, does
// the same job without one.
class WithoutWindow {
public:
    void add_options(CLI::App& app);
    const std::string& settings_file() const { return settings_; }  // empty if none is given
    ExitStatus run(const Error& reason, const EvolutionKinds& kinds) const;

private:
    std::string settings_;
};

}  // namespace cambrian
