#include "app/command_line/completion.h"

#include <fmt/format.h>

namespace cambrian {
namespace {

// The start of the script. $word is the word to complete.
constexpr const char* kHelpers = R"(# Completion for bash.

_cambrian_words() {
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$word")
}

_cambrian_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$word")
}

# Files with one of these endings, and folders that may hold them.
_cambrian_files() {
    local ending
    _cambrian_folders
    for ending; do
        while IFS= read -r file; do
            [[ -d $file ]] || COMPREPLY+=("$file")
        done < <(compgen -f -X "!*$ending" -- "$word")
    done
}

)";

// Returns the command that completes a value; empty if there is none.
std::string offer(const std::string& value) {
    if (is_folder(value)) return "_cambrian_folders";
    if (const auto words = value_words(value); !words.empty())
        return fmt::format("_cambrian_words '{}'", fmt::join(words, " "));
    std::string endings;
    for (const std::string& ending : file_endings(value))
        endings += fmt::format(" '{}'", ending);
    return endings.empty() ? "" : "_cambrian_files" + endings;
}

// Returns the cases in which the word follows an option that takes a value.
std::string value_cases(const Command& command) {
    std::string text;
    for (const CommandOption& option : command.options) {
        if (option.positional || option.value.empty()) continue;
        text += "        ";
        for (const std::string& name : option.names)
            text += fmt::format("{}{},{}", name == option.names.front() ? "" : " | ", command.name,
                                name);
        const std::string values = offer(option.value);
        text += fmt::format(") {}return ;;\n", values.empty() ? "" : values + "; ");
    }
    return text;
}

// Returns the case of a command: its options if the word begins with a dash, else its positionals.
std::string command_case(const Command& command, const std::string& positionals) {
    std::vector<std::string> names;
    for (const CommandOption& option : command.options) {
        if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
    }
    std::string text = fmt::format("        {})\n", command.name);
    text += fmt::format("            if [[ $word == -* ]]; then _cambrian_words '{}'\n",
                        fmt::join(names, " "));
    text += fmt::format("            else {}\n", positionals.empty() ? ":" : positionals);
    return text + "            fi ;;\n";
}

std::string positionals_of(const Command& command) {
    std::string offers;
    for (const CommandOption& option : command.options) {
        if (!option.positional) continue;
        const std::string values = offer(option.value);
        if (!values.empty()) offers += (offers.empty() ? "" : "; ") + values;
    }
    return offers;
}

}  // namespace

std::string bash_completion(const Command& program) {
    std::vector<std::string> names;
    std::string cases = value_cases(program);
    std::string commands;
    for (const Command& command : program.subcommands) {
        names.push_back(command.name);
        cases += value_cases(command);
        commands += command_case(command, positionals_of(command));
    }
    commands += command_case(program, fmt::format("_cambrian_words '{}'", fmt::join(names, " ")));
    return std::string(kHelpers) + "_cambrian() {\n" +
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "    local command=" +
           program.name +
           " i\n"
           "    COMPREPLY=()\n"
           "    for ((i = 1; i < COMP_CWORD; i++)); do\n"
           "        case ${COMP_WORDS[i]} in " +
           fmt::format("{}", fmt::join(names, " | ")) +
           ") command=${COMP_WORDS[i]} && break ;; esac\n"
           "    done\n"
           "    case $command,$before in\n" +
           cases + "    esac\n    case $command in\n" + commands +
           "    esac\n}\n\ncomplete -F _cambrian " + program.name + "\n";
}

}  // namespace cambrian
