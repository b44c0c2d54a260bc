#include "app/command_line/manual.h"

#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class ManualSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& /*app*/) override {}
    ExitStatus run(const EvolutionKinds& /*kinds*/) override {
        return print_result(manual_page(command_tree(), CAMBRIAN_VERSION));
    }
};

}  // namespace

SubcommandKind manual_subcommand() {
    return {.id = "manual",
            .summary = "Write the manual page: every subcommand and option, as roff.",
            .example = "cambrian manual | man -l -",
            .make = make_subcommand<ManualSubcommand>};
}

}  // namespace cambrian
