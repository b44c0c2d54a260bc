#pragma once

// A subcommand of the command line: declares its options, then runs.

#include "app/command_line/command_files.h"
#include "app/process/exit_status.h"
#include "core/registry.h"
#include "evolution/kinds/evolution_kinds.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

class Subcommand {
public:
    virtual ~Subcommand() = default;
    // Values of options are stored in the subcommand, which outlives the parsing.
    virtual void add_options(CLI::App& app) = 0;
    // Returns the files that the subcommand reads and writes, as far as its options tell.
    virtual CommandFiles files() const { return {}; }
    // Returns whether it takes creatures, settings and experiments of three dimensions.
    virtual bool works_in_space() const { return false; }
    // Returns the files that tell of how many dimensions the kinds are, which are one for all.
    virtual std::vector<std::filesystem::path> worlds() const { return files().inputs(); }
    // The kinds are those of the dimensions of its files. Writes results to standard output and
    // messages to standard error.
    virtual ExitStatus run(const EvolutionKinds& kinds) = 0;
};

template <class Made>
std::unique_ptr<Subcommand> make_subcommand() {
    return std::make_unique<Made>();
}

struct SubcommandKind {
    std::string id;
    std::string summary;
    std::string example;  // an example command line
    std::unique_ptr<Subcommand> (*make)() = nullptr;
};

using SubcommandRegistry = Registry<SubcommandKind>;

SubcommandRegistry builtin_subcommands();

}  // namespace cambrian
