#pragma once

// The command line described for other things than parsing: the manual and the shells' completion
// are written from it, so that an option is declared once.

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

struct CommandOption {
    std::vector<std::string> names;  // "-n", "--generations"; of a positional its plain name
    std::string value;               // what it takes, "FILE.toml" or "INT"; empty for a switch
    std::string help;
    bool positional = false;
    bool required = false;
    bool several = false;  // may take more than one value
};

struct Command {
    std::string name;
    std::string summary;
    std::string footer;  // lines with an indentation are to be typed
    std::vector<CommandOption> options;
    std::vector<Command> subcommands;
};

Command describe(const CLI::App& app);

// The program's own.
Command command_tree();

// The endings of the files a value may be, "" for any; none if it is no file.
std::vector<std::string> file_endings(const std::string& value);
bool is_folder(const std::string& value);
// The words a value may be; none if it may be anything.
std::vector<std::string> value_words(const std::string& value);

}  // namespace cambrian
