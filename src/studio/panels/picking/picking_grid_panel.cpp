#include "studio/panels/picking/picking_grid_panel.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "genome/creature_name.h"
#include "pictures/scene/follow_camera.h"
#include "pictures/scene/living_look.h"
#include "pictures/scene/moment.h"
#include "pictures/scene/shaped_ground.h"
#include "pictures/scene/small_life.h"
#include "pictures/scene/space_moment.h"
#include "studio/hand_picking/drag_payload.h"
#include "studio/look/overlays.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr float kCellGap = 4.0F;
constexpr double kBodyShare = 0.7;        // share of a cell that the largest body fills
constexpr std::size_t kTrailLength = 60;  // points of the trail

const GridNode& grid_of(const FrameContext& frame) {
    return frame.picking->snapshot.tree.current();
}

void draw_pick_badge(ImDrawList& list, const Rect& area, int number) {
    const std::string text = std::to_string(number);
    const ImVec2 center = {area.x + area.width - px(17), area.y + px(17)};
    list.AddCircleFilled(center, px(11), paint(colors().accent), 24);
    const float size = 15.0F * ui().scale;
    const ImVec2 words = ui().fonts.strong->CalcTextSizeA(size, 1e6F, 0.0F, text.c_str());
    list.AddText(ui().fonts.strong, size,
                 {std::round(center.x - 0.5F * words.x), std::round(center.y - 0.5F * words.y)},
                 paint(colors().on_accent), text.c_str());
}

void draw_border(ImDrawList& list, const Rect& area, const Color& color, float width) {
    const float inset = 0.5F * width;
    list.AddRect({area.x + inset, area.y + inset},
                 {area.x + area.width - inset, area.y + area.height - inset}, paint(color), px(4),
                 ImDrawFlags_None, width);
}

void draw_waiting(const Rect& area, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ImGui::GetWindowDrawList()->AddText(
        {std::round(area.center().x - 0.5F * size.x), std::round(area.center().y - 0.5F * size.y)},
        paint(colors().muted), text.c_str());
}

// Lists the creature's mutations in the sky above it, as many full lines as there is room for.
void draw_changes(const Rect& area, const Individual& creature, const EvolutionKinds& kinds) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float size = 13.0F * ui().scale;
    const ImVec2 at = {area.x + px(9), area.y + px(25)};
    const float line = ui().fonts.small->CalcTextSizeA(size, 1e6F, 0.0F, "A").y;
    const float room = 0.62F * area.height - px(25);
    const float foot = at.y + line * std::floor(room / line);
    const std::string words = change_words(creature, kinds);
    const float width = area.width - px(18);
    const ImVec2 words_size = ui().fonts.small->CalcTextSizeA(size, 1e6F, width, words.c_str());
    list.PushClipRect({area.x, at.y}, {area.x + area.width, foot}, true);
    list.AddRectFilled({at.x - px(4), at.y}, {at.x + words_size.x + px(4), at.y + words_size.y},
                       paint(with_alpha(colors().sky, 0.75F)), px(3));
    list.AddText(ui().fonts.small, size, at, paint(colors().muted), words.c_str(), nullptr, width);
    list.PopClipRect();
}

// Draws the border and number of a pick and, inside it, the border of the focus.
void draw_borders(const Rect& area, int pick, bool focused) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (pick > 0) {
        draw_pick_badge(list, area, pick);
        draw_border(list, area, colors().accent, px(3));
    }
    if (!focused) return;
    const float inset = pick > 0 ? px(4) : 0.0F;
    const Rect inside = {area.x + inset, area.y + inset, area.width - 2.0F * inset,
                         area.height - 2.0F * inset};
    draw_border(list, inside, with_alpha(colors().text, 0.7F), px(1.5F));
}

std::string score_words(const FrameContext& frame, const Individual& creature) {
    if (!creature.evaluated) return "not judged";
    if (creature.result.outcome != Outcome::kCompleted)
        return std::string(outcome_name(creature.result.outcome));
    return shown_score(creature.result.fitness,
                       goal_unit(grid_of(frame).settings->goal, frame.kinds.goals));
}

}  // namespace

PickingGridPanel::PickingGridPanel(Renderer* renderer) {
    for (SceneCanvas& canvas : canvases_)
        canvas.renderer = renderer;
}

void PickingGridPanel::draw(const FrameContext& frame, Requests& out) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Rect area = {at.x, at.y, room.x, room.y};
    if (frame.picking->snapshot.tree.empty()) {
        draw_waiting(area, picking_words(frame.picking->snapshot) + "…");
        return;
    }
    const std::size_t count =
        std::min({grid_of(frame).creatures.size(), frame.picking->motion.size(), canvases_.size()});
    place_cells(count, area);
    for (SceneCanvas& canvas : canvases_)
        canvas.framebuffer_height = frame.window.framebuffer_height;
    choose_scale(frame.picking->motion);
    look_for_hints(frame);
    for (std::size_t cell = 0; cell < count; ++cell)
        draw_cell(cell, frame, out);
}

void PickingGridPanel::place_cells(std::size_t count, const Rect& area) {
    const int columns = grid_columns(static_cast<int>(count));
    const int rows = (static_cast<int>(count) + columns - 1) / columns;
    const float gap = std::round(px(kCellGap));
    const float width = std::floor((area.width + gap) / static_cast<float>(columns)) - gap;
    const float height = std::floor((area.height + gap) / static_cast<float>(rows)) - gap;
    for (std::size_t cell = 0; cell < count; ++cell) {
        const int columns_before = static_cast<int>(cell) % columns;
        const int rows_before = static_cast<int>(cell) / columns;
        const auto column = static_cast<float>(columns_before);
        const auto row = static_cast<float>(rows_before);
        canvases_[cell].area = {area.x + column * (width + gap), area.y + row * (height + gap),
                                std::max(1.0F, width), std::max(1.0F, height)};
    }
    size_ = {std::max(1.0, static_cast<double>(width)), std::max(1.0, static_cast<double>(height))};
}

// Chooses one scale for all creatures, at which the largest body computed so far fits its cell.
void PickingGridPanel::choose_scale(const GridMotion& motion) {
    scale_ = Camera::kMaxScale;
    for (std::size_t cell = 0; cell < motion.size(); ++cell) {
        const RecordedMotion& each = motion.cell(cell);
        if (each.empty()) continue;
        Camera camera;
        camera.fit(body_window(*each.phenotype, each.frames.front().poses), kBodyShare, size_);
        scale_ = std::min(scale_, camera.pixels_per_metre);
    }
}

void PickingGridPanel::look_for_hints(const FrameContext& frame) {
    const GridNode& grid = grid_of(frame);
    if (hinted_ == grid.creatures.front().get() && hinted_grid_ == grid.number) return;
    hinted_ = grid.creatures.front().get();
    hinted_grid_ = grid.number;
    hints_ = grid_hints(grid.creatures);
}

const char* PickingGridPanel::hint(std::size_t cell) const {
    if (hints_.fastest == cell) return "fastest";
    if (hints_.highest == cell) return "highest";
    return hints_.oddest == cell ? "oddest" : "";
}

void PickingGridPanel::build_scene(std::size_t cell, const FrameContext& frame) {
    SceneCanvas& canvas = canvases_[cell];
    const Palette& palette = colors();
    const GridMotion& motion = frame.picking->motion;
    const RecordedMotion& recorded = motion.cell(cell);
    canvas.frame.clear();
    canvas.frame.detail = detail_of(frame.window.scenery);
    canvas.frame.background = palette.sky;
    if (recorded.empty()) return;
    const MotionFrame shown = recorded.at(motion.time());
    if (frame.in_space()) return build_space(cell, shown, frame);
    const bool ground = motion.environment().has_ground;
    canvas.camera.pixels_per_metre = scale_;
    canvas.camera.center =
        follow_center(shown.center_of_mass.head<2>(), motion.environment(), canvas.camera, size_);
    use_ground(canvas.frame, motion.environment(), canvas.camera, size_);
    const Individual& creature = *grid_of(frame).creatures[cell];
    Character character = character_of(recorded, ground, motion.time());
    character.line = line_or_hue(creature.line, creature.genome->hue);
    if (shown.light) look_at(character, shown.center_of_mass.head<2>(), shown.light->head<2>());
    const CreatureLook look{*recorded.phenotype,  shown.poses, {},
                            creature.genome->hue, {},          shown.stretches,
                            frame.view.look,      character};
    const DrawnWorld* world = shown_world(frame.view, frame.window.scenery, motion.environment());
    if (world != nullptr) {
        use_world(canvas.frame, *world);
    } else if (frame.view.overlays.grid) {
        add_grid(canvas.frame, palette, canvas.camera, size_);
    }
    if (ground) {
        if (world == nullptr) add_ground(canvas.frame, palette, canvas.camera, size_);
        add_shadow(canvas.frame, look);
    }
    if (frame.view.overlays.trail) {
        canvas.frame.add_trail(recorded.trail(motion.time(), kTrailLength),
                               1.6 * canvas.camera.pixel(), with_alpha(palette.accent, 0.8F));
    }
    if (look.mode != LookMode::kMechanics)
        add_small_life(canvas.frame, recorded.scuffs, motion.time(), motion.environment());
    add_being(canvas.frame, palette, canvas.camera, look);
}

void PickingGridPanel::build_space(std::size_t cell, const MotionFrame& shown,
                                   const FrameContext& frame) {
    const GridMotion& motion = frame.picking->motion;
    SpaceLook surroundings;
    surroundings.daytime = daytime_of(frame.view.theme);
    const bool plain =
        frame.window.scenery == Scenery::kPlain || frame.view.look == LookMode::kMechanics;
    surroundings.plain = plain ? &colors() : nullptr;
    surroundings.grid = frame.view.overlays.grid;
    SpaceFrame space = space_frame({.motion = motion.cell(cell),
                                    .shown = shown,
                                    .time = motion.time(),
                                    .environment = motion.environment(),
                                    .creature = *grid_of(frame).creatures[cell],
                                    .surroundings = surroundings,
                                    .look = frame.view.look,
                                    .size = size_,
                                    .pixels_per_metre = scale_,
                                    .trail = frame.view.overlays.trail ? kTrailLength : 0,
                                    .trail_color = colors().accent,
                                    .trail_dot = 1.6});
    if (space.floor) space.floor->ripples = 0.0F;
    SceneCanvas& canvas = canvases_[cell];
    canvas.frame.space = std::make_shared<const SpaceFrame>(std::move(space));
}

void PickingGridPanel::draw_cell(std::size_t cell, const FrameContext& frame, Requests& out) {
    SceneCanvas& canvas = canvases_[cell];
    const Rect& area = canvas.area;
    const GridNode& grid = grid_of(frame);
    const std::string name = fmt::format("cell {}", cell + 1);
    ImGui::SetCursorScreenPos(area.low());
    const TogglePick toggle{grid.number, cell};
    if (ImGui::InvisibleButton(name.c_str(), {area.width, area.height}))
        out.ask(AskPicking{toggle});
    note_place(name);
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && (moved.x != 0.0F || moved.y != 0.0F) && frame.picking->focus != cell)
        out.ask(FocusCell{cell});
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        out.ask(AskPicking{toggle});  // reverses the toggle of the first of the two clicks
        out.ask(ShowCell{cell});
    }
    drag_cell({grid.number, cell});
    if (const auto place = dropped_pin())
        out.ask(AskPicking{PlacePinned{*place, grid.number, cell}});
    build_scene(cell, frame);
    canvas.add_to(*ImGui::GetWindowDrawList());
    draw_words(cell, frame);
    draw_borders(area, pick_number(frame.picking->snapshot, cell), frame.picking->focus == cell);
}

void PickingGridPanel::draw_words(std::size_t cell, const FrameContext& frame) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PickingView& picking = *frame.picking;
    const Rect& area = canvases_[cell].area;
    const float size = 13.0F * ui().scale;
    ImFont* font = ui().fonts.small;
    const auto words = [&](float x, float y, const Color& color, const std::string& text) {
        list.AddText(font, size, {std::round(x), std::round(y)}, paint(color), text.c_str());
    };
    const auto width = [&](const std::string& text) {
        return font->CalcTextSizeA(size, 1e6F, 0.0F, text.c_str()).x;
    };
    if (picking.motion.cell(cell).empty()) {
        draw_waiting(area, picking.motion.cell(cell).complete ? "does not move" : "…");
    }
    if (deciding(picking.snapshot))
        list.AddRectFilled(area.low(), area.high(), paint(with_alpha(colors().sky, 0.55F)));
    const bool parent = cell == 0 && grid_of(frame).origin == GridOrigin::kBreeding;
    words(area.x + px(9), area.y + px(7), colors().muted,
          fmt::format("{} · {}{}", cell + 1, creature_name(*grid_of(frame).creatures[cell]->genome),
                      parent ? " · parent" : ""));
    const float foot = area.y + area.height - px(18);
    if (picking.options.scores)
        words(area.x + px(9), foot, colors().text,
              score_words(frame, *grid_of(frame).creatures[cell]));
    if (picking.focus == cell) draw_changes(area, *grid_of(frame).creatures[cell], frame.kinds);
    const std::string badge = picking.options.hints ? hint(cell) : "";
    words(area.x + area.width - px(9) - width(badge), foot, colors().plot_best, badge);
}

}  // namespace cambrian
