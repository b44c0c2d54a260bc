#pragma once

#include "core/result.h"
#include "pictures/canvas/picture_canvas.h"
#include "render/opengl/offscreen_context.h"

#include <memory>
#include <optional>

namespace cambrian {

// All that is needed to draw pictures of one size without a window, in the order of construction.
struct Workshop {
    std::unique_ptr<OffscreenContext> context;
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<TextRasterizer> text_rasterizer;
    std::optional<PictureCanvas> canvas;
};

// Makes a workshop for pictures of this size in pixels.
Result<std::unique_ptr<Workshop>> open_workshop(int width, int height);

}  // namespace cambrian
