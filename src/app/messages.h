#pragma once

#include "app/exit_status.h"
#include "core/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// One message on standard error, with the program's name before it.
void say(std::string_view message);

// One message for each warning about a file.
void say_of(const std::string& file, const std::vector<std::string>& warnings);

// Says the error and returns the status, so that a subcommand can end with it.
ExitStatus fail(const Error& error, ExitStatus status = ExitStatus::kBadInput);

// A text on standard output, all of it at once. Every result of the program that goes there comes
// through here.
Status print(std::string_view text);
Status print_line(std::string_view line);

// Prints the result of a subcommand and returns the status to end with.
ExitStatus print_result(std::string_view text);
ExitStatus print_result_line(std::string_view line);

}  // namespace cambrian
