#include "app/command_line/completion.h"

#include <fmt/format.h>

namespace cambrian {
namespace {

std::string quoted_for_fish(std::string_view text) {
    std::string result = "'";
    for (const char letter : text) {
        if (letter == '\'' || letter == '\\') result += '\\';
        result += letter;
    }
    return result + "'";
}

// Returns the words and files that a value may be, as a list that fish evaluates.
std::string values_of(const std::string& value) {
    if (is_folder(value)) return "(__fish_complete_directories)";
    std::vector<std::string> values = value_words(value);
    for (const std::string& ending : file_endings(value)) {
        values.push_back(ending.empty() ? "(__fish_complete_path)"
                                        : fmt::format("(__fish_complete_suffix {})", ending));
    }
    return fmt::format("{}", fmt::join(values, " "));
}

std::string line(const std::string& program, const std::string& condition,
                 const CommandOption& option) {
    std::string text = fmt::format("complete -c {} -n {}", program, quoted_for_fish(condition));
    for (const std::string& name : option.names) {
        if (option.positional) break;
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (!option.positional && !option.value.empty()) text += " -x";
    const std::string values = values_of(option.value);
    if (option.positional && values.empty()) return "";
    if (!values.empty()) text += " -a " + quoted_for_fish(values);
    return fmt::format("{}{}\n", text,
                       option.positional ? "" : " -d " + quoted_for_fish(option.help));
}

}  // namespace

std::string fish_completion(const Command& program) {
    std::string text = fmt::format("# Completion for fish.\n\ncomplete -c {} -f\n", program.name);
    for (const CommandOption& option : program.options)
        text += line(program.name, "__fish_use_subcommand", option);
    for (const Command& command : program.subcommands) {
        text += fmt::format("complete -c {} -n '__fish_use_subcommand' -a {} -d {}\n", program.name,
                            command.name, quoted_for_fish(command.summary));
        for (const CommandOption& option : command.options)
            text += line(program.name, "__fish_seen_subcommand_from " + command.name, option);
    }
    return text;
}

}  // namespace cambrian
