#pragma once

#include "app/process/exit_status.h"

namespace cambrian {

// Parses the command line, runs the subcommand (the studio by default) and prints errors.
ExitStatus run_command_line(int argc, char** argv);

}  // namespace cambrian
