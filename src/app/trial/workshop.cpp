#include "app/trial/workshop.h"

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
    auto lettering = Lettering::load();
    if (!lettering) return lettering.error();
    workshop->lettering = std::move(*lettering);
    auto easel = Easel::create(*workshop->renderer, *workshop->lettering, width, height);
    if (!easel) return easel.error();
    workshop->easel.emplace(std::move(*easel));
    return workshop;
}

}  // namespace cambrian
