#include "app/trial/movie_options.h"

#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/picture_size.h"

#include <CLI/CLI.hpp>

namespace cambrian {

void add_movie_options(CLI::App& app, MovieOptions& options) {
    app.add_option("-o,--out", options.out,
                   "Clip to write (*.gif; *.mp4, which needs ffmpeg; *.apng)")
        ->type_name(option_type::kClip)
        ->required();
    app.add_option("--size", options.size,
                   "Size in pixels, each side 64 to 4096; 1280x720 for an MP4 and 640x360 for "
                   "others by default")
        ->type_name("WIDTHxHEIGHT")
        ->check(check_picture_size);
    app.add_option("--theme", options.theme, "Theme of the colors")
        ->check(CLI::IsMember({"dark", "light"}))
        ->capture_default_str();
    take_real(*app.add_option("--fps", options.frames_a_second,
                              "Frames per second; 30 for an MP4 and 20 for others by default"),
              1.0, 120.0);
    take_real(*app.add_option("--speed", options.speed, "Speed, as a multiple of real time")
                   ->default_str("1"),
              0.05, 20.0);
    app.add_flag("--dither", options.dithered,
                 "Mix colors where a GIF has too few; about twice as large");
}

Result<MovieOrder> movie_order(const MovieOptions& options, const std::filesystem::path& path) {
    const ClipFormat* format = clip_format_of(path);
    if (format == nullptr)
        return Error{path.string() + ": expected a name that ends in .mp4, .gif or .apng"};
    if (options.dithered && !format->few_colors)
        return Error{path.string() + ": --dither is for clips of few colors (*.gif, *.apng)"};
    const PictureSides size =
        parse_picture_size(options.size)
            .value_or(PictureSides{format->usual_width, format->usual_height});
    const double rate = options.frames_a_second.value_or(format->usual_rate);
    if (Status possible = check_clip(*format, path, size.width, size.height, rate); !possible)
        return possible.error();
    const Palette palette =
        palette_of(options.theme == "light" ? ThemeKind::kLight : ThemeKind::kDark);
    return MovieOrder{{.format = format,
                       .path = path,
                       .timing = {.frames_a_second = rate, .speed = options.speed},
                       .palette = palette,
                       .dithered = options.dithered},
                      size.width,
                      size.height};
}

}  // namespace cambrian
