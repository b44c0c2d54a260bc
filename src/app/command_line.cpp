#include "app/command_line.h"

#include "app/builtin_kinds.h"
#include "app/command_tree.h"
#include "app/subcommand.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr const char* kStandard = "studio";  // without a subcommand

struct Offered {
    CLI::App* options;
    std::unique_ptr<Subcommand> subcommand;
};

constexpr const char* kProgram = "cambrian";
constexpr const char* kSummary =
    "Cambrian: evolve creatures in two dimensions. Without a subcommand: the studio.";

// Declares everything the program can be asked on its command line.
std::vector<Offered> offer_all(CLI::App& app) {
    app.set_version_flag("--version", "cambrian " CAMBRIAN_VERSION, "Tell the version and exit");
    app.require_subcommand(0, 1);
    app.footer("`cambrian SUBCOMMAND --help` explains one of them, with an example.");
    std::vector<Offered> offered;
    const SubcommandRegistry subcommands = builtin_subcommands();
    for (const SubcommandKind& kind : subcommands.all()) {
        CLI::App* options = app.add_subcommand(kind.id, kind.summary);
        options->footer("Example:\n  " + kind.example);
        offered.push_back({options, kind.make()});
        offered.back().subcommand->add_options(*options);
    }
    return offered;
}

Subcommand* chosen(const std::vector<Offered>& offered) {
    for (const Offered& each : offered) {
        if (each.options->parsed()) return each.subcommand.get();
    }
    for (const Offered& each : offered) {
        if (each.options->get_name() == kStandard) return each.subcommand.get();
    }
    return nullptr;
}

}  // namespace

Command command_tree() {
    CLI::App app(kSummary, kProgram);
    const std::vector<Offered> offered = offer_all(app);
    return describe(app);
}

ExitStatus run_command_line(int argc, char** argv) {
    CLI::App app(kSummary, kProgram);
    const std::vector<Offered> offered = offer_all(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? ExitStatus::kDone : ExitStatus::kBadInput;
    }
    Subcommand* subcommand = chosen(offered);
    CAMBRIAN_ASSERT(subcommand != nullptr, "the standard subcommand is offered");
    return subcommand->run(builtin_kinds());
}

}  // namespace cambrian
