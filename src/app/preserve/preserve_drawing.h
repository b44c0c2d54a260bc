#pragma once

// Pictures and clips of a preserve file.

#include "app/process/long_work.h"
#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "pictures/canvas/palette.h"
#include "pictures/clips/clip_format.h"

#include <filesystem>
#include <optional>
#include <string>

namespace cambrian {

struct PreserveDrawing {
    std::string file;
    std::filesystem::path out;
    const ClipFormat* format = nullptr;  // null for a picture
    int width = 0;                       // pixels
    int height = 0;
    Palette palette;
    // Times of the preserve in s. A picture shows the first, by default the last one kept; a clip
    // goes from one to the other, by default the last minute.
    std::optional<double> from, to;
    double frames_a_second = 0.0;
    double speed = 0.0;
    bool dithered = false;
};

// Computes the preserve from the snapshot before, and draws it.
Status draw_preserve(const PreserveDrawing& drawing, const EvolutionKinds& kinds, LongWork& work);

}  // namespace cambrian
