#include "app/manual.h"

#include "app/messages.h"
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
            .make = []() -> std::unique_ptr<Subcommand> {
                return std::make_unique<ManualSubcommand>();
            }};
}

}  // namespace cambrian
