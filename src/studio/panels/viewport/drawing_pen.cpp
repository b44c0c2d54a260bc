#include "studio/panels/viewport/drawing_pen.h"

#include "core/text/pretty_text.h"
#include "math/angle.h"
#include "sketch/rhythm.h"

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr double kGridStep = 0.05;            // m, with Ctrl
constexpr double kLeastStroke = 4.0;          // units of 1/96 inch; a shorter one is a click
constexpr double kSteady = to_radians(10.0);  // the root turns by more than this only
constexpr double kRootTurn = to_radians(15.0);

SketchRules rules_of(const FrameContext& frame) {
    const ExperimentSettings& settings = frame.viewer.playback.exhibit().settings();
    return {frame.kinds.creature, settings.expression, settings.world.scene};
}

std::string size_words(double length, double least, double most) {
    const char* bound = length >= most ? ", the most" : length <= least ? ", the least" : "";
    return fmt::format("{:.2f} m{}", length, bound);
}
std::string long_words(const BodyPart& part) {
    return size_words(part.length, gene_range::kMinSize, gene_range::kMaxLength);
}
std::string wide_words(const BodyPart& part) {
    return size_words(part.width, gene_range::kMinSize, gene_range::kMaxWidth) + " wide";
}
std::string pen_gene_words(const BodySketch& sketch, std::size_t part) {
    return fmt::format("part {}", sketch.body.parts[part].node);
}
const char* reshaped_words(PenGrip grip) {
    if (grip == PenGrip::kSide) return " width";
    return grip == PenGrip::kJoint ? " place" : " length and angle";
}
// Says what a stroke with that grip changes.
std::string shape_words(PenGrip grip, const BodySketch& sketch, std::size_t part) {
    const NodeGene& node = sketch.node_of(part);
    if (grip == PenGrip::kSide) return fmt::format("{:.3f} m", node.width);
    if (grip == PenGrip::kJoint) return fmt::format("{:.3f}", sketch.edge_of(part).position);
    const double angle = part > 0 ? sketch.edge_of(part).angle : sketch.genome.root_angle;
    return fmt::format("{:.3f} m, {:.1f}°", node.length, to_degrees(angle));
}

}  // namespace

void DrawingPen::follow(const FrameContext& frame) {
    const GenomePtr& shown = frame.viewer.playback.exhibit().genome();
    if (shown == genome_) return;
    genome_ = shown;
    sketch_ = sketch_of(*genome_, rules_of(frame));
    held_ = false;
    preview_.reset();
    lit_.reset();
}

bool DrawingPen::handle_mouse(const FrameContext& frame, const SceneCanvas& canvas, Requests& out) {
    unit_ = static_cast<double>(ui().scale) * canvas.camera.pixel();
    tip_ = canvas.mouse_in_world();
    const bool over = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (!held_) {
        words_.clear();
        if (!over) aim_ = {};
        if (over) look_around(frame.viewer.drawing);
        if (over && aim_.grip != PenGrip::kPaper) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (ImGui::IsItemActive() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press(out);
        return false;
    }
    if ((tip_ - pressed_).norm() > kLeastStroke * unit_) moved_ = true;
    const bool moves_view = aim_.grip == PenGrip::kPaper;
    if (moved_ && !moves_view) draw_on(frame);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return moves_view;
    finish(out);
    return false;
}

// Handles stay while the pointer is near their part, so that those outside of it can be reached.
void DrawingPen::look_around(const DrawingView& drawing) {
    std::optional<std::size_t> chosen;
    if (drawing.chosen) chosen = find_part(sketch_, *drawing.chosen);
    const bool stays =
        lit_ && *lit_ < sketch_.body.parts.size() && is_near_part(sketch_, *lit_, tip_, unit_);
    if (!stays) lit_ = chosen;
    aim_ = pen_aim(sketch_, lit_, tip_, unit_);
    const bool has_handle = lit_ && aim_.part == *lit_ && aim_.grip != PenGrip::kPaper;
    if (has_handle) return;
    if (const auto under = part_under(sketch_, tip_)) lit_ = under;
    aim_ = pen_aim(sketch_, lit_, tip_, unit_);
}

void DrawingPen::press(Requests& out) {
    held_ = true;
    moved_ = false;
    pressed_ = tip_;
    const bool on_part = aim_.grip != PenGrip::kPaper || part_under(sketch_, tip_);
    out.ask(ChoosePart{on_part ? std::optional(name_of(sketch_, aim_.part)) : std::nullopt});
}

void DrawingPen::draw_on(const FrameContext& frame) {
    if (ImGui::GetIO().KeyCtrl) tip_ = (tip_ / kGridStep).array().round().matrix() * kGridStep;
    auto drawn = stroke(frame);
    preview_.reset();
    if (!drawn) {
        words_ = capitalized(drawn.error().message);
        return;
    }
    preview_ = *std::move(drawn);
    const BodyPart& part = preview_->sketch.body.parts[preview_->part];
    const bool slides = aim_.grip == PenGrip::kJoint;
    words_ = slides ? "" : aim_.grip == PenGrip::kSide ? wide_words(part) : long_words(part);
}

void DrawingPen::finish(Requests& out) {
    held_ = false;
    words_.clear();
    const std::optional<Stroke> drawn = std::exchange(preview_, {});
    if (!drawn) return;
    out.ask(EditGenes{std::make_shared<const Genome>(drawn->sketch.genome), drawn->change});
    out.ask(FinishGeneEdit{});
    out.ask(ChoosePart{name_of(drawn->sketch, drawn->part)});
}

// The root keeps its direction while it gets longer, and turns in steps.
Vec2 DrawingPen::steadied(const Vec2& end) const {
    const double length = end.norm();
    const double before = sketch_.genome.root_angle;
    const double wanted = arc_tangent2(end.y(), end.x());
    const bool turns = std::fabs(wrap_angle(wanted - before)) > kSteady;
    const double angle = turns ? std::round(wanted / kRootTurn) * kRootTurn : before;
    const SineCosine turn = sine_cosine(angle);
    return length * Vec2(turn.cosine, turn.sine);
}

Result<DrawingPen::Stroke> DrawingPen::growth(const FrameContext& frame) const {
    const SketchRules rules = rules_of(frame);
    auto grown =
        grow_part(sketch_, aim_.part, {aim_.from, tip_, frame.viewer.drawing.mirror}, rules);
    if (!grown) return grown.error();
    Stroke drawn{sketch_of(std::move(grown->genome), rules), {}, 0};
    // A new part joins in.
    if (const auto rhythm = rhythm_of(sketch_, rules)) {
        if (auto moving = with_rhythm(drawn.sketch, *rhythm, rules))
            drawn.sketch = sketch_of(*std::move(moving), rules);
    }
    drawn.part = find_part(drawn.sketch, grown->name).value_or(0);
    drawn.change = {pen_gene_words(drawn.sketch, drawn.part), "",
                    fmt::format("{:.2f} m, drawn", drawn.sketch.body.parts[drawn.part].length)};
    return drawn;
}

Genome DrawingPen::reshaped() const {
    const std::size_t part = aim_.part;
    if (aim_.grip == PenGrip::kSide) return drag_side(sketch_, part, aim_.from + tip_ - pressed_);
    if (aim_.grip == PenGrip::kJoint)
        return slide_joint(sketch_, part, joint_place(sketch_, part) + tip_ - pressed_);
    if (part > 0) return drag_end(sketch_, part, tip_);
    return drag_end(sketch_, part, steadied(aim_.grip == PenGrip::kBack ? Vec2(-tip_) : tip_));
}

Result<DrawingPen::Stroke> DrawingPen::stroke(const FrameContext& frame) const {
    if (aim_.grip == PenGrip::kGrow) return growth(frame);
    Stroke drawn{sketch_of(reshaped(), rules_of(frame)), {}, 0};
    const auto part = find_part(drawn.sketch, name_of(sketch_, aim_.part));
    if (!part) return Error{"there it would lie inside another part"};
    drawn.part = *part;
    drawn.change = {pen_gene_words(sketch_, aim_.part) + reshaped_words(aim_.grip),
                    shape_words(aim_.grip, sketch_, aim_.part),
                    shape_words(aim_.grip, drawn.sketch, *part)};
    return drawn;
}

}  // namespace cambrian
