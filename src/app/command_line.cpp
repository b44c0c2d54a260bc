#include "app/command_line.h"

#include "app/builtin_kinds.h"
#include "app/command_line/command_tree.h"
#include "app/command_line/option_types.h"
#include "app/command_line/subcommand.h"
#include "app/process/messages.h"
#include "persist/experiment/file_dimensions.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr const char* kStandard = "studio";  // the subcommand that runs if none is given

struct Offered {
    CLI::App* options;
    std::unique_ptr<Subcommand> subcommand;
};

constexpr const char* kProgram = "cambrian";
constexpr const char* kSummary =
    "Cambrian: evolve creatures in two dimensions, and swimmers in three. Without a subcommand: "
    "the "
    "studio.";

// Declares all subcommands and options of the program.
std::vector<Offered> offer_all(CLI::App& app) {
    app.set_version_flag("--version", "cambrian " CAMBRIAN_VERSION, "Print the version and exit");
    app.require_subcommand(0, 1);
    app.footer("`cambrian SUBCOMMAND --help` explains a subcommand, with an example.");
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

// Prints help, the version or the error that parsing found.
ExitStatus answer(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream text;
    if (app.exit(error, text, text) == 0) return print_result(text.str());
    std::string command = kProgram;
    for (const CLI::App* subcommand : app.get_subcommands())
        command += " " + subcommand->get_name();
    return fail({fmt::format("{}; `{} --help` explains", error.what(), command)});
}

// Checks that no option has an empty value; only folders may be empty.
Status check_names(const CLI::App& app) {
    for (const CLI::App* subcommand : app.get_subcommands()) {
        for (const CLI::Option* option : subcommand->get_options()) {
            if (option->count() == 0 || option->get_type_name() == option_type::kFolder) continue;
            const std::vector<std::string>& values = option->results();
            if (std::find(values.begin(), values.end(), "") != values.end())
                return Error{option->get_name() + ": expected a value, found nothing"};
        }
    }
    return {};
}

// Returns how many dimensions the files of a subcommand have; those that it has not are of no
// matter.
Result<int> dimensions_of(const Subcommand& subcommand) {
    std::filesystem::path first;
    int dimensions = 0;
    for (const std::filesystem::path& input : subcommand.worlds()) {
        const int own = dimensions_of_file(input);
        if (own == 3 && !subcommand.works_in_space())
            return Error{input.string() +
                         ": lives in three dimensions, in which this command does not work yet; "
                         "studio, view, evolve, simulate, verify, render, rescore, export and "
                         "settings do"};
        if (dimensions != 0 && own != dimensions)
            return Error{fmt::format("{} lives in {} dimensions and {} in {}; expected one of both",
                                     first.string(), dimensions, input.string(), own)};
        dimensions = own;
        first = input;
    }
    return dimensions == 3 ? 3 : 2;
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
        return answer(app, error);
    }
    Subcommand* subcommand = chosen(offered);
    CAMBRIAN_ASSERT(subcommand != nullptr, "the standard subcommand is offered");
    if (const Status named = check_names(app); !named) return fail(named.error());
    if (const Status usable = subcommand->files().check(); !usable) return fail(usable.error());
    const Result<int> dimensions = dimensions_of(*subcommand);
    if (!dimensions) return fail(dimensions.error());
    return subcommand->run(builtin_kinds(*dimensions));
}

}  // namespace cambrian
