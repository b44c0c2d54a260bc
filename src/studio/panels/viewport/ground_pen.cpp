#include "studio/panels/viewport/ground_pen.h"

#include "studio/panels/viewport/viewport_labels.h"
#include "world/ground_stroke.h"

#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kPenPixels = 3.0;  // between two points of a stroke
constexpr std::size_t kMostPenPoints = 4000;
constexpr const char* kHint =
    "Drag a line: it becomes the ground between its ends  ·  Shift: straight  ·  "
    "Ctrl+Z takes it back  ·  D ends";

}  // namespace

bool GroundPen::handle_mouse(const FrameContext& frame, const SceneCanvas& canvas, Requests& out) {
    if (!frame.viewer.ground_pen || !frame.may_draw_ground()) {
        stroke_.clear();
        return false;
    }
    const Vec2 mouse = canvas.mouse_in_world();
    if (stroke_.empty()) {
        if (ImGui::IsItemActive() && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            stroke_.push_back({mouse.x(), mouse.y()});
        return true;
    }
    out.ask(HoldShown{});
    const GroundPoint& last = stroke_.back();
    const double moved = std::hypot(mouse.x() - last.x, mouse.y() - last.y);
    if (moved > kPenPixels * canvas.camera.pixel() && stroke_.size() < kMostPenPoints)
        stroke_.push_back({mouse.x(), mouse.y()});
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return true;
    auto points = snapped_stroke(std::exchange(stroke_, {}), ImGui::GetIO().KeyShift);
    if (!points.empty()) out.ask(DrawGround{std::move(points)});
    return true;
}

void GroundPen::add_stroke(SceneCanvas& canvas) const {
    const double width = 2.5 * canvas.camera.pixel();
    const auto points = snapped_stroke(stroke_, ImGui::GetIO().KeyShift);
    for (std::size_t i = 1; i < points.size(); ++i)
        canvas.frame.add_line({points[i - 1].x, points[i - 1].y}, {points[i].x, points[i].y}, width,
                              colors().accent);
}

void GroundPen::draw_hint(const SceneCanvas& canvas) {
    cambrian::draw_hint(canvas, kHint);
}

}  // namespace cambrian
