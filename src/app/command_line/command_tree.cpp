#include "app/command_line/command_tree.h"

#include "app/command_line/option_types.h"

#include <CLI/CLI.hpp>

#include <sstream>

namespace cambrian {
namespace {

// CLI11 appends the checks to the type: "UINT:INT in [1 - 1024]", "FLOAT:NONNEGATIVE".
std::string value_of(const CLI::Option& option) {
    if (option.get_type_size() == 0) return "";
    std::string type = option.get_type_name();
    const std::size_t colon = type.find(':');
    if (colon == std::string::npos) return type;
    const std::string checked = type.substr(colon + 1);
    const bool tells = checked.find_first_of("[{") != std::string::npos;
    return tells ? checked : type.substr(0, colon);
}

CommandOption describe(const CLI::Option& option) {
    CommandOption described{.names = {},
                            .value = value_of(option),
                            .help = option.get_description(),
                            .standard = option.get_default_str(),
                            .positional = option.get_positional(),
                            .required = option.get_required(),
                            .several = option.get_items_expected_max() > 1};
    for (const std::string& name : option.get_snames())
        described.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        described.names.push_back("--" + name);
    if (described.positional) described.names.push_back(option.get_single_name());
    return described;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(part);
    return parts;
}

}  // namespace

Command describe(const CLI::App& app) {
    Command command{.name = app.get_name(),
                    .summary = app.get_description(),
                    .footer = app.get_footer(),
                    .options = {},
                    .subcommands = {}};
    for (const CLI::Option* option : app.get_options())
        command.options.push_back(describe(*option));
    for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; }))
        command.subcommands.push_back(describe(*subcommand));
    return command;
}

std::vector<std::string> file_endings(const std::string& value) {
    std::vector<std::string> endings;
    const std::string file = option_type::kFile;
    for (const std::string& each : split(value, '|')) {
        if (each.starts_with(file)) endings.push_back(each.substr(file.size()));
    }
    return endings;
}

bool is_folder(const std::string& value) {
    return value == option_type::kFolder;
}

std::vector<std::string> value_words(const std::string& value) {
    const std::size_t open = value.find('{');
    const std::size_t close = value.find('}');
    if (open == std::string::npos || close == std::string::npos) return {};
    return split(value.substr(open + 1, close - open - 1), ',');
}

}  // namespace cambrian
