#pragma once

#include "app/process/exit_status.h"

namespace cambrian {

// Parses, runs the subcommand asked for (the studio if none is) and says what went wrong.
ExitStatus run_command_line(int argc, char** argv);

}  // namespace cambrian
