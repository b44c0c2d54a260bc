#include "studio/panels/viewport/viewport_labels.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "pictures/scene/follow_camera.h"
#include "pictures/scene/scene_builder.h"
#include "studio/look/overlays.h"
#include "studio/playback/trial_words.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cambrian {
namespace {

// Pixels from the top that the text about the creature takes.
constexpr float kWordsHeight = 132.0F;
constexpr float kActionsHeight = 34.0F;  // of the buttons below the words
constexpr float kHintRoom = 12.0F;       // pixels below the hint

void shadowed_text(ImDrawList& list, ImFont* font, float size, const ImVec2& at, const Color& color,
                   const std::string& text) {
    note_letters(text);
    list.AddText(font, size, {at.x, at.y + 1.0F}, paint(with_alpha(colors().sky, 0.9F)),
                 text.c_str());
    list.AddText(font, size, at, paint(color), text.c_str());
}

std::string second_line(const FrameContext& frame) {
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    const GoalKind* goal = frame.kinds.goals.find(exhibit.settings().goal);
    std::string line = goal == nullptr ? std::string() : goal->label;
    if (goal != nullptr && frame.viewer.score != nullptr) {
        line += "  ·  " + shown_score(frame.viewer.score->score.value, goal->unit);
    }
    if (const std::string number = trial_words(frame.viewer.playback); !number.empty())
        line += (line.empty() ? "" : "  ·  ") + number;
    const Trial& trial = frame.viewer.playback.trial();
    const std::string clock = trial.settling() ? "settling" : fmt::format("{:.1f} s", trial.time());
    line += (line.empty() ? "" : "  ·  ") + clock;
    if (trial.finished()) line += " (trial over)";
    return line;
}

const DrawnWorld* world_around(const FrameContext& frame) {
    return shown_world(frame.view, frame.window.scenery,
                       frame.viewer.playback.creature().replay().environment());
}

void draw_ground_labels(const FrameContext& frame, const SceneCanvas& canvas) {
    const DrawnWorld* world = world_around(frame);
    if (!frame.viewer.playback.creature().replay().environment().has_ground) return;
    if (world != nullptr && !frame.view.overlays.ruler) return;
    const Camera& camera = canvas.camera;
    const WorldWindow window = camera.window(canvas.size());
    const GroundShape& ground = canvas.frame.ground;
    if (ground.is_flat() && window.low.y() > 0.0) return;
    // Places labels at marks of the ground, far enough apart for their text.
    const double tick = mark_spacing(camera, kTickPixels);
    const double room = kTickPixels * static_cast<double>(ui().scale);
    const double spacing = tick * std::ceil(room / (tick * camera.pixels_per_metre));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WithFont font(ui().fonts.small);
    const Color color = world != nullptr ? world->words : colors().muted;
    for (double i = std::ceil(window.low.x() / spacing); i * spacing < window.high.x(); i += 1.0) {
        const std::string label = with_unit(i * spacing, "m");
        const Vec2 at = camera.to_screen({i * spacing, ground.at(i * spacing)}, canvas.size());
        const float width = ImGui::CalcTextSize(label.c_str()).x;
        const float left = static_cast<float>(at.x()) - 0.5F * width;
        if (left < 0.0F || left + width > canvas.area.width) continue;
        list.AddText({std::round(canvas.area.x + left),
                      std::round(canvas.area.y + static_cast<float>(at.y()) + px(10))},
                     paint(color), label.c_str());
    }
}

// Labels the lines of the ground's grid that cross at the start.
void draw_grid_labels(const FrameContext& frame, const SceneCanvas& canvas,
                      const SpaceView& space) {
    const DrawnWorld* world = world_around(frame);
    if (!frame.viewer.playback.creature().replay().environment().has_ground) return;
    if (world != nullptr ? !frame.view.overlays.ruler : !frame.view.overlays.grid) return;
    constexpr int kLabelsEachWay = 12;
    const PlayedCreature& body = frame.viewer.playback.creature();
    const SpaceCamera camera = space.camera().seen(canvas.size());
    Camera flat;
    flat.pixels_per_metre = camera.pixels_per_metre;
    const double spacing = std::max(1.0, mark_spacing(flat, kTickPixels));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WithFont font(ui().fonts.small);
    const Color color = world != nullptr ? world->words : colors().muted;
    const auto label = [&](const Vec3& at, double metres) {
        const SpaceCamera::Seen seen = camera.look_at(at);
        const std::string words = with_unit(metres, "m");
        const auto x = static_cast<float>(seen.place.x());
        const auto y = static_cast<float>(seen.place.y());
        const ImVec2 size = ImGui::CalcTextSize(words.c_str());
        const bool near = seen.distance > 0.2 && seen.distance < 4.0 * camera.distance();
        const bool hidden =
            part_at(body.phenotype(), body.motion().poses(), camera, seen.place + Vec2(8.0, 8.0))
                .part >= 0;
        if (!near || hidden || x < 0.0F || y < 0.0F || x + size.x > canvas.area.width ||
            y + size.y > canvas.area.height)
            return;
        list.AddText({std::round(canvas.area.x + x + px(3)), std::round(canvas.area.y + y)},
                     paint(color), words.c_str());
    };
    const auto nearest = [&](double metres) { return std::round(metres / spacing); };
    for (int i = -kLabelsEachWay; i <= kLabelsEachWay; ++i) {
        const double along = (nearest(camera.target.x()) + i) * spacing;
        label({along, 0.0, 0.0}, along);
        const double aside = (nearest(camera.target.z()) + i) * spacing;
        if (aside != 0.0) label({0.0, 0.0, aside}, aside);
    }
}

// Draws each ghost's name at its middle.
void draw_space_ghost_labels(const FrameContext& frame, const SceneCanvas& canvas,
                             const SpaceView& space) {
    for (const auto& ghost : frame.viewer.ghosts) {
        if (!ghost->poses().empty())
            draw_plate(canvas, space.on_canvas(ghost->trial().scene().center_of_mass(), canvas),
                       ghost->words());
    }
}

// Says how far the wall is while it is out of view.
void draw_wall_sign(const FrameContext& frame, const SceneCanvas& canvas) {
    constexpr double kFromEdge = 46.0;  // pixels
    const FixedBox* wall = frame.viewer.playback.trial().wall();
    if (wall == nullptr) return;
    const WorldWindow view = canvas.camera.window(canvas.size());
    const bool left = wall->high.x() < view.low.x();
    if (!left && wall->low.x() <= view.high.x()) return;
    const Vec3 here = frame.viewer.playback.creature().motion().center();
    const double away = distance_to_wall(*wall, here, left ? -1 : 1);
    const double margin = kFromEdge * static_cast<double>(ui().scale) * canvas.camera.pixel();
    draw_plate(canvas, {left ? view.low.x() + margin : view.high.x() - margin, 0.5 * kWallHeight},
               "wall " + with_unit(away, "m"));
}

// Draws the parts' names; leaves out those that would cover another one.
void draw_part_names(const FrameContext& frame, const SceneCanvas& canvas, const SpaceView& space) {
    const Phenotype& phenotype = frame.viewer.playback.creature().phenotype();
    const auto& poses = frame.viewer.playback.creature().motion().poses();
    std::vector<Vec2> taken;
    const double line = static_cast<double>(px(20)) * canvas.camera.pixel();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::string name =
            i == 0 ? "root" : fmt::format("{} · gene {}", i, phenotype.parts[i].node);
        const Vec3& middle = poses[i].position;
        const Vec2 at = frame.in_space() ? space.on_canvas(middle, canvas) : Vec2(middle.head<2>());
        const auto covers = [&](const Vec2& other) {
            return std::fabs(other.x() - at.x()) < 5.0 * line &&
                   std::fabs(other.y() - at.y()) < line;
        };
        if (std::any_of(taken.begin(), taken.end(), covers)) continue;
        taken.push_back(at);
        draw_plate(canvas, at, name);
    }
}

// Returns the words of a ghost; those of one outside the view say how far it is from the creature.
std::string ghost_words(const SceneCanvas& canvas, const Ghost& ghost, const WorldWindow& bounds,
                        double here) {
    const WorldWindow view = canvas.camera.window(canvas.size());
    const double away = std::fabs(0.5 * (bounds.low.x() + bounds.high.x()) - here);
    if (bounds.low.x() > view.high.x())
        return fmt::format("{}  ·  {:.1f} m →", ghost.words(), away);
    if (bounds.high.x() < view.low.x())
        return fmt::format("← {:.1f} m  ·  {}", away, ghost.words());
    return ghost.words();
}

// Draws each ghost's name above it, or at the edge if it is outside the view; moves a label that
// would cover another one.
void draw_ghost_labels(const FrameContext& frame, const SceneCanvas& canvas) {
    std::vector<Vec2> taken;
    const double line = static_cast<double>(px(20)) * canvas.camera.pixel();
    // Labels stay below the text about the creature.
    const double highest =
        canvas.camera.to_world({0.0, static_cast<double>(px(kWordsHeight))}, canvas.size()).y();
    const WorldWindow view = canvas.camera.window(canvas.size());
    const double here = frame.viewer.playback.creature().motion().center().x();
    for (const auto& ghost : frame.viewer.ghosts) {
        const WorldWindow bounds = body_window(ghost->phenotype(), ghost->poses());
        const std::string words = ghost_words(canvas, *ghost, bounds, here);
        const double half = 0.5 *
                            static_cast<double>(ImGui::CalcTextSize(words.c_str()).x + px(16)) *
                            canvas.camera.pixel();
        Vec2 at = {0.5 * (bounds.low.x() + bounds.high.x()),
                   std::min(bounds.high.y() + line, highest)};
        at.x() = std::max(view.low.x() + half, std::min(view.high.x() - half, at.x()));
        const auto covers = [&](const Vec2& other) {
            return std::fabs(other.x() - at.x()) < 4.5 * line &&
                   std::fabs(other.y() - at.y()) < 0.99 * line;
        };
        double step = line;
        while (std::any_of(taken.begin(), taken.end(), covers)) {
            if (at.y() + step > highest) step = -line;
            at.y() += step;
        }
        taken.push_back(at);
        draw_plate(canvas, at, words);
    }
}

void draw_creature_words(const FrameContext& frame, const SceneCanvas& canvas) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Fonts& fonts = ui().fonts;
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    const DrawnWorld* world = world_around(frame);
    const Palette& palette = world != nullptr ? palette_over(*world) : colors();
    ImVec2 at = {canvas.area.x + px(16), canvas.area.y + px(12)};
    // A shade, so that words are read before any sky.
    const ImU32 shade = paint(with_alpha(palette.sky, 0.75F));
    const ImU32 none = paint(with_alpha(palette.sky, 0.0F));
    list.AddRectFilledMultiColor(
        canvas.area.low(),
        {canvas.area.x + std::min(px(320), canvas.area.width), canvas.area.y + px(96)}, shade, none,
        none, none);
    const Color second = world != nullptr ? with_alpha(palette.text, 0.85F) : palette.muted;
    const std::string name = exhibit.name();
    shadowed_text(list, fonts.title, px(20), at, palette.text, name);
    const float named = fonts.title->CalcTextSizeA(px(20), 1e6F, 0.0F, name.c_str()).x;
    if (exhibit.title != name)
        shadowed_text(list, fonts.body, px(15), {at.x + named + px(10), at.y + px(4)}, second,
                      exhibit.title);
    at.y += px(27);
    shadowed_text(list, fonts.body, px(15), at, second, second_line(frame));
    at.y += px(22) + (has_actions(frame) ? px(kActionsHeight) : 0.0F);
    if (frame.viewer.playback.creature().replay().diverged()) {
        shadowed_text(list, fonts.body, px(15), at, palette.danger,
                      "The motion diverged; press R to restart");
    } else if (const auto& lesions = frame.viewer.playback.creature().lesions(); !lesions.empty()) {
        const Phenotype& whole = frame.viewer.playback.creature().whole();
        shadowed_text(list, fonts.body, px(15), at, palette.plot_best,
                      "Lesion: " + words_of(lesions, whole, frame.kinds.creature));
    } else if (is_disturbed(frame.viewer.playback.creature())) {
        shadowed_text(list, fonts.body, px(15), at, palette.plot_best,
                      "Disturbed by hand; press R to restart");
    }
}

}  // namespace

void draw_plate(const SceneCanvas& canvas, const Vec2& at, const std::string& words) {
    const Vec2 place = canvas.camera.to_screen(at, canvas.size());
    const WithFont font(ui().fonts.small);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const ImVec2 low = {std::round(canvas.area.x + static_cast<float>(place.x()) - 0.5F * size.x),
                        std::round(canvas.area.y + static_cast<float>(place.y()) - 0.5F * size.y)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x - px(5), low.y - px(1)},
                       {low.x + size.x + px(5), low.y + size.y + px(1)},
                       paint(with_alpha(colors().panel, 0.85F)), px(4));
    list.AddText(low, paint(colors().text), words.c_str());
}

void draw_hint(const SceneCanvas& canvas, const std::string& words) {
    const WithFont font(ui().fonts.small);
    const std::string shown = fit_text(words, canvas.area.width - px(40));
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    const float left = canvas.area.x + 0.5F * (canvas.area.width - size.x);
    const ImVec2 low = {std::round(left),
                        std::round(canvas.area.y + canvas.area.height - size.y - px(kHintRoom))};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x - px(8), low.y - px(4)},
                       {low.x + size.x + px(8), low.y + size.y + px(4)},
                       paint(with_alpha(colors().panel, 0.88F)), px(6));
    list.AddText(low, paint(colors().text), shown.c_str());
}

bool has_actions(const FrameContext& frame) {
    return !frame.viewer.playback.empty() && !frame.window.viewer_only &&
           !frame.window.presenting && frame.picking == nullptr && frame.preserve == nullptr;
}

void draw_viewport_labels(const FrameContext& frame, const SceneCanvas& canvas,
                          const SpaceView& space) {
    if (frame.in_space()) {
        draw_grid_labels(frame, canvas, space);
        draw_space_ghost_labels(frame, canvas, space);
    } else {
        draw_ground_labels(frame, canvas);
        draw_wall_sign(frame, canvas);
        draw_ghost_labels(frame, canvas);
    }
    if (frame.view.overlays.names) draw_part_names(frame, canvas, space);
    draw_creature_words(frame, canvas);
}

}  // namespace cambrian
