#pragma once

#include "app/process/exit_status.h"
#include "core/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Everything that is printed passes these functions, which let no text of a file steer the terminal
// (core/text/shown_text.h).

// Prints a message to standard error, after the program's name.
void say(std::string_view message);

// Prints one message for each warning about a file.
void say_of(const std::string& file, const std::vector<std::string>& warnings);

// Prints the error and returns the status, so that a subcommand can end with it.
ExitStatus fail(const Error& error, ExitStatus status = ExitStatus::kBadInput);

// Prints text to standard output in one piece. All results on standard output are printed by these
// functions.
Status print(std::string_view text);
Status print_line(std::string_view line);

// Prints the result of a subcommand and returns the exit status.
ExitStatus print_result(std::string_view text);
ExitStatus print_result_line(std::string_view line);

}  // namespace cambrian
