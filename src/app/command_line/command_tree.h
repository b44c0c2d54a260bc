#pragma once

// A description of the command line. The manual and the shells' completion are made from it, so
// that each option is declared once.

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

struct CommandOption {
    std::vector<std::string> names;  // "-n", "--generations"; the plain name of a positional
    std::string value;               // type of the value: "FILE.toml" or "INT"; empty for a switch
    std::string help;
    std::string standard;  // default value; empty if there is none or the help tells it
    bool positional = false;
    bool required = false;
    bool several = false;  // may take more than one value
};

struct Command {
    std::string name;
    std::string summary;
    std::string footer;  // indented lines are commands to type
    std::vector<CommandOption> options;
    std::vector<Command> subcommands;
};

Command describe(const CLI::App& app);

// Returns the description of this program.
Command command_tree();

// Returns the file name endings of a value that is a file, "" for any; empty if it is not a file.
std::vector<std::string> file_endings(const std::string& value);
bool is_folder(const std::string& value);
// Returns the words that a value may be; empty if it may be anything.
std::vector<std::string> value_words(const std::string& value);

}  // namespace cambrian
