#pragma once

// The options that films and races share: all of a clip but what it shows.

#include "core/result.h"
#include "pictures/clip.h"

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

struct MovieOptions {
    std::string out;
    std::string size;  // "WIDTHxHEIGHT"
    std::string theme = "dark";
    std::optional<double> frames_a_second;
    double speed = 1.0;
    bool dithered = false;
};

void add_movie_options(CLI::App& app, MovieOptions& options);

// What a clip shall be, and its size in pixels.
struct MovieOrder {
    ClipOrder clip;
    int width = 0;
    int height = 0;
};

// Fails if the name is not that of a clip or if its format cannot show it. The clip's seconds are
// left at 0.
Result<MovieOrder> movie_order(const MovieOptions& options, const std::filesystem::path& path);

}  // namespace cambrian
