#include "studio/host/scene_canvas.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

Vec2 mouse_in(const Rect& area) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {static_cast<double>(mouse.x - area.x), static_cast<double>(mouse.y - area.y)};
}

void draw_canvas(const ImDrawList*, const ImDrawCmd* command) {
    const auto& canvas = *static_cast<const SceneCanvas*>(command->UserCallbackData);
    const auto whole = [](float pixels) { return static_cast<int>(pixels); };
    const PixelRect target{
        whole(canvas.area.x),
        canvas.framebuffer_height - whole(canvas.area.y) - whole(canvas.area.height),
        whole(canvas.area.width), whole(canvas.area.height)};
    canvas.renderer->draw(canvas.frame, canvas.camera, target, Baking::kInSteps);
}

}  // namespace

Viewport SceneCanvas::size() const {
    return {std::max(1.0, static_cast<double>(area.width)),
            std::max(1.0, static_cast<double>(area.height))};
}

Vec2 SceneCanvas::mouse_in_world() const {
    return camera.to_world(mouse_in(area), size());
}

void SceneCanvas::zoom_by_wheel(bool about_middle) {
    const auto notches = static_cast<double>(ImGui::GetIO().MouseWheel);
    if (notches == 0.0) return;
    const Viewport viewport = size();
    camera.zoom_about(
        about_middle ? Vec2(0.5 * viewport.width, 0.5 * viewport.height) : mouse_in(area),
        std::pow(kNotchFactor, notches), viewport);
}

void SceneCanvas::add_to(ImDrawList& list) {
    if (renderer == nullptr || area.width < 1.0F || area.height < 1.0F) return;
    list.AddCallback(draw_canvas, this);
    list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

}  // namespace cambrian
