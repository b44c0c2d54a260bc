#include "studio/host/scene_canvas.h"

namespace cambrian {
namespace {

void draw_canvas(const ImDrawList*, const ImDrawCmd* command) {
    const auto& canvas = *static_cast<const SceneCanvas*>(command->UserCallbackData);
    const auto whole = [](float pixels) { return static_cast<int>(pixels); };
    const PixelRect target{
        whole(canvas.area.x),
        canvas.framebuffer_height - whole(canvas.area.y) - whole(canvas.area.height),
        whole(canvas.area.width), whole(canvas.area.height)};
    canvas.renderer->draw(canvas.frame, canvas.camera, target);
}

}  // namespace

void SceneCanvas::add_to(ImDrawList& list) {
    if (renderer == nullptr || area.width < 1.0F || area.height < 1.0F) return;
    list.AddCallback(draw_canvas, this);
    list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

}  // namespace cambrian
