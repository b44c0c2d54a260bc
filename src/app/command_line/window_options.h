#pragma once

#include "app/command_line/command_files.h"
#include "studio/studio.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// Adds the options of every subcommand that opens a window: its size, its log files and its
// screenshot.
void add_window_options(CLI::App& app, StudioOptions& options);

// Returns the log files and the screenshot that the options name.
CommandFiles window_files(const StudioOptions& options);

}  // namespace cambrian
