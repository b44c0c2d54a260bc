#include "app/command_line/completion.h"

#include <fmt/format.h>

namespace cambrian {
namespace {

// Quotes text for an argument of _arguments in single quotes, where colons and brackets have a
// meaning.
std::string quoted_for_zsh(std::string_view text) {
    std::string result;
    for (const char letter : text) {
        if (letter == '\'') {
            result += "'\\''";
        } else {
            if (letter == ':' || letter == '[' || letter == ']' || letter == '\\') result += '\\';
            result += letter;
        }
    }
    return result;
}

// Returns an action of _arguments such as FILE.toml:_files -g "*.toml".
std::string action(const std::string& value) {
    if (is_folder(value)) return "_files -/";
    std::string text;
    if (const auto words = value_words(value); !words.empty())
        return fmt::format("({})", fmt::join(words, " "));
    for (const std::string& ending : file_endings(value))
        text += (text.empty() ? "*" : "|*") + ending;
    if (text.empty()) return " ";
    return fmt::format("_files -g \"{}\"",
                       text.find('|') == std::string::npos ? text : fmt::format("({})", text));
}

std::string argument(const CommandOption& option) {
    const std::string message =
        fmt::format("{}:{}", quoted_for_zsh(option.help), action(option.value));
    if (option.positional) {
        const std::string place = option.several ? "*" : option.required ? "1" : "::";
        return fmt::format("'{}{}'", place == "::" ? "1::" : place + ":", message);
    }
    std::string names = fmt::format("{}", fmt::join(option.names, ","));
    if (option.names.size() > 1) names = fmt::format("{{{}}}", names);
    std::string text = option.several ? "'*'" : fmt::format("'({})'", fmt::join(option.names, " "));
    text += fmt::format("{}'[{}]", names, quoted_for_zsh(option.help));
    if (!option.value.empty())
        text += fmt::format(":{}:{}", quoted_for_zsh(option.value), action(option.value));
    return text + "'";
}

std::string arguments(const Command& command, const std::string& indent) {
    std::string text;
    for (const CommandOption& option : command.options)
        text += fmt::format(" \\\n{}{}", indent, argument(option));
    return text;
}

}  // namespace

std::string zsh_completion(const Command& program) {
    std::string names;
    std::string cases;
    for (const Command& command : program.subcommands) {
        names += fmt::format("        '{}:{}'\n", command.name, quoted_for_zsh(command.summary));
        cases += fmt::format("            {})\n                _arguments{} ;;\n", command.name,
                             arguments(command, "                    "));
    }
    return "#compdef " + program.name +
           "\n# Completion for zsh.\n\n_cambrian() {\n    local curcontext=$curcontext state line\n"
           "    local -a subcommands=(\n" +
           names + "    )\n    _arguments -C" + arguments(program, "        ") +
           " \\\n        '1:subcommand:->subcommand' '*::argument:->argument'\n"
           "    case $state in\n"
           "        subcommand) _describe subcommand subcommands ;;\n"
           "        argument) case $words[1] in\n" +
           cases +
           "        esac ;;\n"
           "    esac\n}\n\nif [[ $zsh_eval_context[-1] == loadautofunc ]]; then _cambrian \"$@\"\n"
           "else compdef _cambrian " +
           program.name + "\nfi\n";
}

}  // namespace cambrian
