#pragma once

#include "app/command_files.h"
#include "studio/studio.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// What every subcommand that opens a window offers: its size and what is written about it.
void add_window_options(CLI::App& app, StudioOptions& options);

// What is written about the window.
CommandFiles window_files(const StudioOptions& options);

}  // namespace cambrian
