#include "studio/panels/viewport/drawing_paper.h"

#include "core/text/counted.h"
#include "pictures/scene/follow_camera.h"
#include "pictures/scene/living_look.h"
#include "sketch/pairs.h"
#include "studio/panels/viewport/viewport_labels.h"
#include "studio/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr double kPaperShare = 0.5;       // of the viewport that the body fills at first
constexpr double kLeastPaperWidth = 1.6;  // m
constexpr const char* kPaperHint =
    "Drag from an edge: a new part  ·  an end: length and direction  ·  a side: width  ·  "
    "the middle: along its parent  ·  Ctrl: on the grid";
constexpr const char* kShortPaperHint = "Drag from an edge: a new part  ·  drag a handle: its size";

Color paper_color() {
    return ui().theme == ThemeKind::kLight ? color_of(0xFBF9F3) : color_of(0x1C2027);
}

std::vector<Pose> rest_poses(const Phenotype& body) {
    std::vector<Pose> poses;
    for (const PlannedPart& part : body.plan.parts)
        poses.push_back(part.rest_pose);
    return poses;
}

std::vector<Vec2> rest_corners(const PlannedPart& part) {
    std::vector<Vec2> corners;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0})
            corners.push_back(
                in_world(part, {x * part.half_extents.x(), y * part.half_extents.y()}));
    }
    return corners;
}

double lowest_point(const BodySketch& sketch) {
    double lowest = 0.0;
    for (const PlannedPart& part : sketch.body.plan.parts) {
        for (const Vec2& corner : rest_corners(part))
            lowest = std::min(lowest, corner.y());
    }
    return lowest;
}

// The length of 1/96 inch on the paper, in m.
double paper_unit(const SceneCanvas& canvas) {
    return static_cast<double>(ui().scale) * canvas.camera.pixel();
}

void add_plus(SceneFrame& scene, const Vec2& at, double unit) {
    scene.add_circle(at, 9.0 * unit, colors().accent);
    const Vec2 along(4.5 * unit, 0.0);
    const Vec2 up(0.0, 4.5 * unit);
    scene.add_line(at - along, at + along, 2.0 * unit, colors().on_accent);
    scene.add_line(at - up, at + up, 2.0 * unit, colors().on_accent);
}

void add_dashes(SceneFrame& scene, const Vec2& from, const Vec2& to, double unit,
                const Color& color) {
    const Vec2 way = to - from;
    const int count = std::clamp(static_cast<int>(way.norm() / (12.0 * unit)), 1, 200);
    for (int i = 0; i < count; ++i) {
        const Vec2 start = from + way * (static_cast<double>(i) / count);
        scene.add_line(start, start + way * (0.5 / count), 1.5 * unit, color);
    }
}

bool paper_button(const char* label, const char* help, ButtonLook look = ButtonLook::kPlain) {
    const bool pressed = push_button(label, {.look = look, .height = px(26), .tooltip = help});
    ImGui::SameLine();
    return pressed;
}

}  // namespace

void DrawingPaper::handle_mouse(const FrameContext& frame, SceneCanvas& canvas, Requests& out) {
    pen_.follow(frame);
    if (ImGui::IsItemHovered()) canvas.zoom_by_wheel(false);
    const bool pulls_view = pen_.handle_mouse(frame, canvas, out);
    const bool dragged =
        pulls_view || (ImGui::IsItemActive() && (ImGui::IsMouseDragging(ImGuiMouseButton_Right) ||
                                                 ImGui::IsMouseDragging(ImGuiMouseButton_Middle)));
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (dragged) canvas.camera.pan({static_cast<double>(moved.x), static_cast<double>(moved.y)});
    if (pen_.lit()) {
        const int node = pen_.body().body.parts[*pen_.lit()].node;
        out.ask(ShowHighlight{{.node = node}});
    }
}

void DrawingPaper::place_camera(SceneCanvas& canvas, bool fits) {
    if (!fits) return;
    const BodySketch& sketch = pen_.body();
    WorldWindow bounds = body_window(sketch.body, rest_poses(sketch.body));
    const Vec2 middle = 0.5 * (bounds.low + bounds.high);
    const Vec2 least(0.5 * kLeastPaperWidth, 0.25 * kLeastPaperWidth);
    bounds.low = bounds.low.cwiseMin(middle - least);
    bounds.high = bounds.high.cwiseMax(middle + least);
    canvas.camera.fit(bounds, kPaperShare, canvas.size());
}

void DrawingPaper::build_scene(const FrameContext& frame, SceneCanvas& canvas) const {
    canvas.frame.background = paper_color();
    add_grid(canvas.frame, colors(), canvas.camera, canvas.size());
    add_ground(frame, canvas);
    add_body(frame, canvas);
    if (pen_.aim().grip == PenGrip::kGrow) add_mirror(canvas, frame.viewer.drawing.mirror);
    if (pen_.refused())
        canvas.frame.add_line(pen_.aim().place, pen_.tip(), 2.5 * paper_unit(canvas),
                              colors().danger);
    if (!pen_.is_drawing()) add_handles(canvas);
}

// The ground is where the body would touch it at first.
void DrawingPaper::add_ground(const FrameContext& frame, SceneCanvas& canvas) const {
    if (!frame.viewer.playback.exhibit().settings().world.environment.has_ground) return;
    const double height = lowest_point(pen_.body());
    const WorldWindow view = canvas.camera.window(canvas.size());
    if (view.low.y() >= height) return;
    const Vec2 low(view.low.x(), view.low.y());
    const Vec2 high(view.high.x(), height);
    canvas.frame.add_box(0.5 * (low + high), 0.5 * (high - low),
                         with_alpha(colors().ground, 0.55F));
    canvas.frame.add_line({low.x(), height}, {high.x(), height}, 1.5 * paper_unit(canvas),
                          colors().ground_line);
}

void DrawingPaper::add_body(const FrameContext& frame, SceneCanvas& canvas) const {
    const BodySketch& sketch = pen_.body();
    const std::vector<Pose> poses = rest_poses(sketch.body);
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    Character character;
    character.line = line_or_hue(exhibit.individual().line, exhibit.genome()->hue);
    const CreatureLook look{sketch.body,      poses,    {}, exhibit.genome()->hue, {}, {},
                            LookMode::kGlass, character};
    add_being(canvas.frame, colors(), canvas.camera, look);
    std::optional<std::size_t> chosen = pen_.drawn();
    if (!chosen && frame.viewer.drawing.chosen)
        chosen = find_part(sketch, *frame.viewer.drawing.chosen);
    for (std::size_t part = 0; part < sketch.body.parts.size(); ++part) {
        const bool is_copy =
            chosen && sketch.body.parts[part].node == sketch.body.parts[*chosen].node;
        const bool is_lit = pen_.lit() == part && !pen_.is_drawing();
        if (is_copy || is_lit)
            add_frame_of(canvas, part, with_alpha(colors().accent, is_copy ? 1.0F : 0.5F));
    }
}

void DrawingPaper::add_frame_of(SceneCanvas& canvas, std::size_t part, const Color& color) const {
    const PlannedPart& planned = pen_.body().body.plan.parts[part];
    const double unit = paper_unit(canvas);
    Shape shape;
    shape.center = planned.rest_pose.position.head<2>();
    shape.half_extents = planned.half_extents.head<2>().array() + 3.0 * unit;
    shape.angle = planned.rest_angle;
    shape.radius = 4.0 * unit;
    shape.outline_width = 2.0 * unit;
    shape.fill = with_alpha(color, 0.0F);
    shape.outline = color;
    canvas.frame.shapes.push_back(shape);
}

// Shows the axis about which a new part would be mirrored.
void DrawingPaper::add_mirror(SceneCanvas& canvas, MirrorSides sides) const {
    if (sides == MirrorSides::kNone || is_on_both_sides(pen_.body(), pen_.aim().part)) return;
    const PlannedPart& parent = pen_.body().body.plan.parts[pen_.aim().part];
    const double beyond = 60.0 * paper_unit(canvas);
    const bool along = axis_of(sides, parent.rest_angle) == MirrorAxis::kAlong;
    const Vec2 half = along ? Vec2(parent.half_extents.x() + beyond, 0.0)
                            : Vec2(0.0, parent.half_extents.y() + beyond);
    add_dashes(canvas.frame, in_world(parent, -half), in_world(parent, half), paper_unit(canvas),
               colors().plot_median);
}

void DrawingPaper::add_handles(SceneCanvas& canvas) const {
    SceneFrame& scene = canvas.frame;
    const double unit = paper_unit(canvas);
    const PenAim& aim = pen_.aim();
    if (pen_.lit()) {
        const PlannedPart& part = pen_.body().body.plan.parts[*pen_.lit()];
        for (const PenAim& handle : pen_handles(pen_.body(), *pen_.lit(), unit)) {
            const bool aimed = aim.grip == handle.grip && aim.place == handle.place;
            const double size = aimed ? 1.25 : 1.0;
            switch (handle.grip) {
                case PenGrip::kJoint:
                    scene.add_circle(handle.place, 6.5 * size * unit, colors().accent);
                    scene.add_circle(handle.place, 4.0 * size * unit, paper_color());
                    break;
                case PenGrip::kSide: {
                    const Vec2 along = in_world(part, {8.0 * size * unit, 0.0}) -
                                       part.rest_pose.position.head<2>();
                    scene.add_line(handle.place - along, handle.place + along, 5.0 * size * unit,
                                   colors().accent);
                    break;
                }
                case PenGrip::kGrow:
                    scene.add_line(handle.from, handle.place, 1.5 * unit,
                                   with_alpha(colors().accent, 0.6F));
                    add_plus(scene, handle.place, size * unit);
                    break;
                default:
                    scene.add_circle(handle.place, 7.5 * size * unit, paper_color());
                    scene.add_circle(handle.place, 5.5 * size * unit, colors().accent);
            }
        }
    }
    if (aim.grip == PenGrip::kGrow && aim.place == aim.from) add_plus(scene, aim.place, unit);
}

void DrawingPaper::draw_words(const SceneCanvas& canvas, Requests& out) const {
    if (!pen_.words().empty())
        draw_plate(canvas, pen_.tip() + Vec2(0.0, 24.0 * paper_unit(canvas)), pen_.words());
    const bool fits =
        ui().fonts.small->CalcTextSizeA(ui().fonts.small->FontSize, 1e6F, 0.0F, kPaperHint).x <
        canvas.area.width - px(40);
    draw_hint(canvas, fits ? kPaperHint : kShortPaperHint);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = {canvas.area.x + px(16), canvas.area.y + px(12)};
    list.AddText(ui().fonts.title, px(20), at, paint(colors().text), "Drawing");
    const Phenotype& body = pen_.body().body;
    const std::string second =
        counted(body.parts.size(), "part") + "  ·  " + counted(body.effectors.size(), "joint");
    list.AddText(ui().fonts.body, px(15), {at.x, at.y + px(27)}, paint(colors().muted),
                 second.c_str());
    ImGui::SetCursorScreenPos({at.x - px(2), at.y + px(52)});
    const WithFont font(ui().fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(6), px(4)));
    if (paper_button("Play it", "Lay the pen down and watch it in its world (P)",
                     ButtonLook::kPrimary))
        out.ask(ToggleDrawing{});
    if (paper_button("Evolve from it",
                     "A new run that begins with this creature and random ones. Ctrl+Z goes back "
                     "to the run before."))
        out.ask(EvolveShown{false});
    if (paper_button("New creature", "Begin again with one part")) out.ask(DrawNewCreature{});
    if (paper_button("Save it", "In a file of its own, or as a card (Ctrl+S)"))
        out.ask(OpenFilePanel{FileTask::kSaveCreature});
    ImGui::NewLine();
    ImGui::PopStyleVar();
}

}  // namespace cambrian
