#include "app/command_line/window_options.h"

#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "studio/look/overlays.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace cambrian {

void add_window_options(CLI::App& app, StudioOptions& options) {
    take_whole(*app.add_option("--width", options.drawing.width,
                               "Width of the window in units of 1/96 inch")
                    ->capture_default_str(),
               320, 16384);
    take_whole(*app.add_option("--height", options.drawing.height,
                               "Height of the window in units of 1/96 inch")
                    ->capture_default_str(),
               240, 16384);
    take_real(*app.add_option("--scale", options.drawing.scale,
                              "Pixels per 1/96 inch of everything drawn; the display's by default"),
              0.5, 4.0);
    app.add_option_function<std::string>(
           "--scenery",
           [&options](const std::string& name) { options.scenery = scenery_named(name); },
           "Detail of the scenery that is drawn; as it was left, at first automatic, by default")
        ->check(
            CLI::IsMember(std::vector<std::string>(kSceneryNames.begin(), kSceneryNames.end())));
    app.add_option("--status-log", options.status_log,
                   "File to append events to, as JSON, one object per line")
        ->type_name(option_type::kFile);
    app.add_option("--frame-log", options.frame_log, "File for the times of every frame, as CSV")
        ->type_name(option_type::kFile);
    app.add_option("--screenshot", options.screenshot,
                   "File for a picture of the window at its end")
        ->type_name(option_type::kPicture);
    take_real(*app.add_option("--quit-after", options.quit_after,
                              "Time in seconds after which the window closes; never by default"),
              0.0, 1e9);
    take_real(*app.add_option("--frame-rate", options.drawing.frame_rate,
                              "Largest number of frames per second")
                   ->capture_default_str(),
              1.0, 1000.0);
}

CommandFiles window_files(const StudioOptions& options) {
    return CommandFiles()
        .appends(options.status_log)
        .appends(options.frame_log, output_form::kTable)
        .writes(options.screenshot, output_form::kPicture);
}

}  // namespace cambrian
