#include "pictures/workshop.h"

#include <utility>

namespace cambrian {

Result<std::unique_ptr<Workshop>> open_workshop(int width, int height) {
    auto workshop = std::make_unique<Workshop>();
    auto context = OffscreenContext::create();
    if (!context) return context.error();
    workshop->context = std::move(*context);
    auto renderer = Renderer::create();
    if (!renderer) return renderer.error();
    workshop->renderer = std::move(*renderer);
    auto text_rasterizer = TextRasterizer::load();
    if (!text_rasterizer) return text_rasterizer.error();
    workshop->text_rasterizer = std::move(*text_rasterizer);
    auto canvas =
        PictureCanvas::create(*workshop->renderer, *workshop->text_rasterizer, width, height);
    if (!canvas) return canvas.error();
    workshop->canvas.emplace(std::move(*canvas));
    return workshop;
}

}  // namespace cambrian
