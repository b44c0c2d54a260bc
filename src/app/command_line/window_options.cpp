#include "app/command_line/window_options.h"

#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"

#include <CLI/CLI.hpp>

namespace cambrian {

void add_window_options(CLI::App& app, StudioOptions& options) {
    take_whole(*app.add_option("--width", options.drawing.width, "Width of the window"), 320,
               16384);
    take_whole(*app.add_option("--height", options.drawing.height, "Height of the window"), 240,
               16384);
    take_real(*app.add_option("--scale", options.drawing.scale,
                              "Size of everything drawn; the display's unless given"),
              0.5, 4.0);
    app.add_option("--status-log", options.status_log,
                   "Append what happens to this file, one JSON object a line")
        ->type_name(option_type::kFile);
    app.add_option("--frame-log", options.frame_log, "Write the time of every frame to this file")
        ->type_name(option_type::kFile);
    app.add_option("--screenshot", options.screenshot, "Write a picture of the window at the end")
        ->type_name(option_type::kPicture);
    take_real(*app.add_option("--quit-after", options.quit_after,
                              "Close the window after so many seconds"),
              0.0, 1e9);
    take_real(*app.add_option("--frame-rate", options.drawing.frame_rate,
                              "Draw at most so many frames a second"),
              1.0, 1000.0);
}

CommandFiles window_files(const StudioOptions& options) {
    return CommandFiles()
        .appends(options.status_log)
        .appends(options.frame_log)
        .writes(options.screenshot);
}

}  // namespace cambrian
