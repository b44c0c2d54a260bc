#include "app/command_line/manual.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace cambrian {
namespace {

// Escapes the text for roff.
std::string plain(std::string_view text) {
    std::string result;
    for (const char letter : text) {
        const bool first = result.empty() || result.back() == '\n';
        if (first && (letter == '.' || letter == '\'')) result += "\\&";
        if (letter == '\\') {
            result += "\\e";
        } else if (letter == '-') {
            result += "\\-";
        } else if (letter == '`' || letter == '\'') {
            result += letter == '`' ? "\\(ga" : "\\(aq";
        } else {
            result += letter;
        }
    }
    return result;
}

std::string bold(std::string_view text) {
    return fmt::format("\\fB{}\\fR", plain(text));
}
std::string italic(std::string_view text) {
    return fmt::format("\\fI{}\\fR", plain(text));
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    return text;
}

// Returns a heading such as "-n, --generations INT".
std::string heading(const CommandOption& option) {
    std::string names;
    for (const std::string& name : option.names) {
        if (!names.empty()) names += ", ";
        names += option.positional ? italic(upper(name)) : bold(name);
    }
    if (option.positional || option.value.empty()) return names;
    return fmt::format("{} {}{}", names, italic(option.value), option.several ? "..." : "");
}

std::string option_entry(const CommandOption& option) {
    const bool shows_kind = option.positional && !option.value.empty();
    const std::string standard =
        option.standard.empty() ? "" : fmt::format(" (default: {})", plain(option.standard));
    return fmt::format(".TP\n{}\n{}{}\n{}", heading(option), plain(option.help), standard,
                       shows_kind ? fmt::format("({})\n", italic(option.value)) : "");
}

std::string synopsis_of(const CommandOption& option) {
    std::string text = italic(upper(option.names.front())) + (option.several ? "..." : "");
    return option.required ? text : fmt::format("[{}]", text);
}

// Returns the entries of the positionals, then those of the options.
std::string option_entries(const Command& command) {
    std::string text;
    for (const bool positional : {true, false}) {
        for (const CommandOption& option : command.options) {
            if (option.positional == positional) text += option_entry(option);
        }
    }
    return text;
}

// Formats indented lines as examples and the others as prose.
std::string footer_text(const std::string& footer) {
    std::string text;
    std::istringstream lines(footer);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find_first_not_of(' ');
        if (start == std::string::npos) continue;
        const std::string shown = plain(line.substr(start));
        text += start == 0 ? fmt::format(".PP\n{}\n", shown)
                           : fmt::format(".PP\n.nf\n.RS\n{}\n.RE\n.fi\n", shown);
    }
    return text;
}

std::string subcommand_section(const Command& program, const Command& command) {
    std::string line = bold(fmt::format("{} {}", program.name, command.name));
    for (const CommandOption& option : command.options) {
        if (option.positional) line += " " + synopsis_of(option);
    }
    return fmt::format(".SS {}\n{} [{}]\n.PP\n{}\n{}{}", plain(command.name), line,
                       italic("OPTIONS"), plain(command.summary), option_entries(command),
                       footer_text(command.footer));
}

// Removes the program's name: "Cambrian: evolve creatures in two dimensions. Without ...".
std::string short_summary(const std::string& summary) {
    const std::size_t start = summary.find(": ");
    const std::string rest = start == std::string::npos ? summary : summary.substr(start + 2);
    return rest.substr(0, rest.find('.'));
}

}  // namespace

std::string manual_page(const Command& program, std::string_view version) {
    std::string text = fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n.ad l\n",
                                   upper(program.name), program.name, version);
    text +=
        fmt::format(".SH NAME\n{} \\- {}\n", program.name, plain(short_summary(program.summary)));
    text += fmt::format(".SH SYNOPSIS\n{} [{} [{}]]\n", bold(program.name), italic("SUBCOMMAND"),
                        italic("OPTIONS"));
    text +=
        fmt::format(".SH DESCRIPTION\n{}\n{}", plain(program.summary), footer_text(program.footer));
    text += fmt::format(".SH OPTIONS\n{}.SH SUBCOMMANDS\n", option_entries(program));
    for (const Command& command : program.subcommands)
        text += subcommand_section(program, command);
    return text +
           ".SH EXIT STATUS\n.TP\n0\nSuccess.\n.TP\n2\nA fault in the command line or in a file.\n"
           ".TP\n1\nAny other fault.\n.PP\nMessages go to standard error.\n";
}

}  // namespace cambrian
