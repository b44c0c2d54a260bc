#include "studio/panels/opening/founders_panel.h"

#include "core/text/pretty_text.h"
#include "genome/creature_name.h"
#include "pictures/scene/follow_camera.h"
#include "pictures/scene/living_look.h"
#include "pictures/scene/moment.h"
#include "pictures/scene/scenery.h"
#include "pictures/scene/shaped_ground.h"
#include "pictures/scene/small_life.h"
#include "pictures/scene/space_being.h"
#include "pictures/scene/space_world.h"
#include "render/orbit_camera.h"
#include "studio/look/overlays.h"
#include "studio/panels/viewport/space_overlays.h"
#include "studio/panels/viewport/viewport_tools.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostInARow = 7;
constexpr double kSlotShare = 2.1;   // body sizes between two creatures of a row
constexpr double kRowShare = 0.215;  // of the view's height between two rows
constexpr double kRowDepth = 1.25;   // slots between two rows in space
constexpr double kCrowdYaw = to_radians(14.0);
constexpr double kCrowdPitch = to_radians(21.0);
constexpr double kCrowdShare = 0.94;  // of the view in space, filled by all creatures
constexpr double kMeadow = 0.11;      // slots; height of a row's ground above its creatures' feet
constexpr double kReliefStep = 4.0;   // pixels between two points of a row's ground
constexpr int kBands = 10;            // of colour in the ground of a row
constexpr double kLowestShare = 0.5;  // slots; least distance of two rows

// Returns the colour of the ground of a row, which is paler the farther it is.
Color row_color(const DrawnWorld* world, std::size_t row) {
    const auto far = static_cast<float>(row);
    if (world == nullptr) return mix(colors().ground, colors().sky, 0.25F * far);
    return mix(world->recipe.ground[0], world->recipe.ridges[2][0], 0.26F * far);
}

// Draws grass along the top of a row's ground.
void add_row_blades(SceneFrame& scene, const DrawnWorld& world, const WorldWindow& window,
                    double top, std::size_t row, double pixel) {
    if (world.grass.a <= 0.0F) return;
    const Color color = mix(world.grass, row_color(&world, row), 0.35F);
    const double spacing = 9.0 * pixel;
    const auto count = static_cast<std::uint64_t>((window.high.x() - window.low.x()) / spacing) + 1;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto draw = [&](std::uint64_t use) { return chance(i, 8 * row + use); };
        const double x = window.low.x() + (static_cast<double>(i) + draw(1)) * spacing;
        const double tall = (2.0 + 8.0 * draw(2) * draw(3)) * pixel;
        scene.add_line({x, top - pixel}, {x + 0.5 * (draw(4) - 0.5) * tall, top + tall},
                       1.6 * pixel, color);
    }
}

std::vector<Scuff> moved_scuffs(const RecordedMotion& motion, double time, const Vec2& by) {
    const std::span<const Scuff> seen = scuffs_seen(motion.scuffs, time);
    std::vector<Scuff> moved(seen.begin(), seen.end());
    for (Scuff& scuff : moved)
        scuff.place += by;
    return moved;
}

const std::array<const char*, kMostFounders + 1> kNumbers = {
    "No",       "One",     "Two",     "Three",     "Four",     "Five",     "Six",
    "Seven",    "Eight",   "Nine",    "Ten",       "Eleven",   "Twelve",   "Thirteen",
    "Fourteen", "Fifteen", "Sixteen", "Seventeen", "Eighteen", "Nineteen", "Twenty"};

}  // namespace

void FoundersPanel::draw(const FrameContext& frame, Requests& out) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const FounderCrowd& crowd = *frame.coach.founders;
    canvas_.area = {at.x, at.y, room.x, room.y};
    canvas_.framebuffer_height = frame.window.framebuffer_height;
    const bool pressed =
        ImGui::InvisibleButton("founders", {std::max(1.0F, room.x), std::max(1.0F, room.y)});
    note_place("founders");
    ImGui::SetItemAllowOverlap();
    in_space_ = frame.in_space();
    place_rows(crowd);
    if (in_space_) place_in_space(crowd);
    if (pressed) out.ask(ChooseFounder{nearest(canvas_.mouse_in_world(), crowd)});
    in_space_ ? build_space(frame) : build_scene(frame);
    canvas_.add_to(*ImGui::GetWindowDrawList());
    draw_choice(frame);
    draw_words(frame);
    draw_viewport_tools(frame, canvas_.area, out);
}

void FoundersPanel::place_rows(const FounderCrowd& crowd) {
    const std::size_t count = crowd.founders().size();
    const std::size_t row_count = (count + kMostInARow - 1) / kMostInARow;
    rows_.assign(row_count, {});
    std::size_t placed = 0;
    for (std::size_t i = 0; i < row_count; ++i) {
        rows_[i].first = placed;
        rows_[i].count = (count - placed) / (row_count - i);
        placed += rows_[i].count;
    }
    slot_ = kSlotShare * crowd.big_body();
    const bool ground = crowd.motion().environment().has_ground;
    Camera& camera = canvas_.camera;
    const Viewport size = canvas_.size();
    const double across = (static_cast<double>(rows_.back().count) + 0.5) * slot_;
    camera.pixels_per_metre = std::clamp(size.width / across, Camera::kMinScale, Camera::kMaxScale);
    // Rows of creatures stand on level ground.
    Environment level = crowd.motion().environment();
    level.terrain = {};
    camera.center = follow_center(Vec2::Zero(), level, camera, size);
    const double apart = std::max(kRowShare * size.height * camera.pixel(), kLowestShare * slot_);
    for (std::size_t i = 0; i < row_count; ++i) {
        const auto up = static_cast<double>(i);
        rows_[i].lift = ground
                            ? up * apart
                            : (up - 0.5 * static_cast<double>(row_count - 1)) * apart - 0.3 * apart;
    }
}

std::size_t FoundersPanel::row_of(std::size_t place) const {
    std::size_t number = rows_.size() - 1;
    while (number > 0 && place < rows_[number].first)
        --number;
    return number;
}

// Looks at all creatures, whose rows are behind each other.
void FoundersPanel::place_in_space(const FounderCrowd& crowd) {
    OrbitCamera orbit;
    orbit.yaw = kCrowdYaw;
    orbit.pitch = kCrowdPitch;
    std::vector<Vec3> points;
    const double reach = 0.6 * crowd.big_body();
    for (std::size_t place = 0; place < crowd.founders().size(); ++place) {
        const double depth = -kRowDepth * slot_ * static_cast<double>(row_of(place));
        for (const double side : {-reach, reach})
            points.emplace_back(stand(place).x() + side, side, depth);
    }
    orbit.fit(points, kCrowdShare, canvas_.size());
    space_camera_ = orbit.seen(canvas_.size());
    // The words above the crowd need room.
    space_camera_.target += 0.05 * orbit.distance * space_camera_.up;
    canvas_.camera.pixels_per_metre = 1.0;
    canvas_.camera.center = {0.5 * canvas_.size().width, -0.5 * canvas_.size().height};
}

Vec3 FoundersPanel::shift_of(std::size_t place, const FounderCrowd& crowd) const {
    const Vec3& start = crowd.motion().cell(place).frames.front().center_of_mass;
    const double up = crowd.motion().environment().has_ground ? 0.0 : -start.y();
    const double depth = -kRowDepth * slot_ * static_cast<double>(row_of(place));
    return {stand(place).x() - start.x(), up, depth - start.z()};
}

void FoundersPanel::build_space(const FrameContext& frame) {
    const FounderCrowd& crowd = *frame.coach.founders;
    const GridMotion& motion = crowd.motion();
    canvas_.frame.clear();
    auto space = std::make_shared<SpaceFrame>();
    space->camera = space_camera_;
    const bool plain =
        frame.window.scenery == Scenery::kPlain || frame.view.look == LookMode::kMechanics;
    SpaceLook surroundings;
    surroundings.daytime = daytime_of(frame.view.theme);
    surroundings.plain = plain ? &colors() : nullptr;
    surroundings.grid = frame.view.overlays.grid && plain;
    surroundings.time = motion.time();
    use_space(*space, motion.environment(), surroundings);
    if (frame.window.scenery == Scenery::kLight && space->floor) space->floor->ripples = 0.0F;
    for (std::size_t place = 0; place < crowd.founders().size(); ++place) {
        const RecordedMotion& recorded = motion.cell(place);
        if (recorded.empty()) continue;
        MotionFrame shown = recorded.at(motion.time());
        std::vector<Pose> posture = recorded.frames.front().poses;
        const Vec3 shift = shift_of(place, crowd);
        for (Pose& pose : shown.poses)
            pose.position += shift;
        const Individual& founder = *crowd.founders()[place];
        CreatureLook look{*recorded.phenotype, shown.poses};
        look.hue = founder.genome->hue;
        look.mode = frame.view.look;
        look.character.line = line_or_hue(founder.line, look.hue);
        look.character.posture = posture;
        look.character.time = motion.time();
        SpaceManner manner;
        manner.way = space_way_of(recorded.frames.back().center_of_mass -
                                  recorded.frames.front().center_of_mass);
        add_being(*space, look, manner);
    }
    canvas_.frame.space = std::move(space);
}

Vec2 FoundersPanel::middle_of(std::size_t place, const FounderCrowd& crowd) const {
    const RecordedMotion& motion = crowd.motion().cell(place);
    const Vec3 here = motion.at(crowd.motion().time()).center_of_mass;
    if (in_space_) return in_picture(space_camera_, here + shift_of(place, crowd));
    return here.head<2>() + shift_in_row(place, here.x(), crowd);
}

Vec2 FoundersPanel::top_of(std::size_t place, const FounderCrowd& crowd) const {
    const RecordedMotion& motion = crowd.motion().cell(place);
    const MotionFrame shown = motion.at(crowd.motion().time());
    if (!in_space_) {
        const WorldWindow body = body_window(*motion.phenotype, shown.poses);
        const Vec2 by = shift_in_row(place, shown.center_of_mass.x(), crowd);
        return Vec2(0.5 * (body.low.x() + body.high.x()), body.high.y()) + by;
    }
    std::vector<Vec3> corners;
    add_corners(corners, *motion.phenotype, shown.poses);
    const Vec3 shift = shift_of(place, crowd);
    Vec2 top = middle_of(place, crowd);
    for (const Vec3& corner : corners)
        top.y() = std::max(top.y(), in_picture(space_camera_, corner + shift).y());
    return top;
}

// Returns where a creature's trial has its origin in the view. Rows are staggered.
Vec2 FoundersPanel::stand(std::size_t place) const {
    const std::size_t number = row_of(place);
    const Row& row = rows_[number];
    const double across = static_cast<double>(place - row.first) -
                          0.5 * static_cast<double>(row.count - 1) +
                          (number % 2 == 0 ? -0.15 : 0.15);
    return {across * slot_, row.lift};
}

// On ground with a shape, a creature that has left its place goes on over that of another one.
Vec2 FoundersPanel::shift_in_row(std::size_t place, double x, const FounderCrowd& crowd) const {
    const Row& row = rows_[row_of(place)];
    Vec2 by = stand(place);
    by.x() -= crowd.motion().cell(place).frames.front().center_of_mass.x();
    by.y() +=
        ground_of_row(row, x + by.x(), crowd) - ground_height(crowd.motion().environment(), x);
    return by;
}

std::size_t FoundersPanel::nearest_in(const Row& row, double x) const {
    std::size_t best = row.first;
    for (std::size_t place = row.first; place < row.first + row.count; ++place) {
        if (std::fabs(stand(place).x() - x) < std::fabs(stand(best).x() - x)) best = place;
    }
    return best;
}

double FoundersPanel::ground_of_row(const Row& row, double x, const FounderCrowd& crowd) const {
    const std::size_t place = nearest_in(row, x);
    const RecordedMotion& motion = crowd.motion().cell(place);
    const double start = motion.empty() ? 0.0 : motion.frames.front().center_of_mass.x();
    return ground_height(crowd.motion().environment(), x - stand(place).x() + start);
}

GroundShape FoundersPanel::shape_of_row(const Row& row, const FounderCrowd& crowd) const {
    GroundShape shape;
    if (crowd.motion().environment().terrain.is_flat()) return shape;
    const WorldWindow window = canvas_.camera.window(canvas_.size());
    const double step = kReliefStep * canvas_.camera.pixel();
    for (double x = window.low.x() - step; x < window.high.x() + 2.0 * step; x += step)
        shape.surface.emplace_back(x, ground_of_row(row, x, crowd));
    return shape;
}

// Raises the top of a row's ground to its shape.
void FoundersPanel::add_relief(const Row& row, double top, const Color& color,
                               const FounderCrowd& crowd) {
    const double half = 0.5 * kReliefStep * canvas_.camera.pixel();
    for (const Vec2& point : shape_of_row(row, crowd).surface) {
        if (point.y() > 0.0)
            canvas_.frame.add_box({point.x() + half, top + 0.5 * point.y()},
                                  {half, 0.5 * point.y()}, color);
    }
}

std::size_t FoundersPanel::nearest(const Vec2& point, const FounderCrowd& crowd) const {
    std::size_t best = 0;
    double least = 1e9;
    for (std::size_t i = 0; i < crowd.founders().size(); ++i) {
        const RecordedMotion& motion = crowd.motion().cell(i);
        if (motion.empty()) continue;
        const Vec2 at = middle_of(i, crowd);
        const double away = (at - point).norm();
        if (away >= least) continue;
        least = away;
        best = i;
    }
    return best;
}

void FoundersPanel::build_scene(const FrameContext& frame) {
    const GridMotion& motion = frame.coach.founders->motion();
    SceneFrame& scene = canvas_.frame;
    scene.clear();
    scene.detail = detail_of(frame.window.scenery);
    scene.background = colors().sky;
    const DrawnWorld* world = shown_world(frame.view, frame.window.scenery, motion.environment());
    scene.ground = shape_of_row(rows_.front(), *frame.coach.founders);
    if (world != nullptr) {
        add_scenery(scene, *world, canvas_.camera, canvas_.size(), motion.time());
    } else if (motion.environment().has_ground) {
        add_ground(scene, colors(), canvas_.camera, canvas_.size());
    }
    for (std::size_t i = rows_.size(); i-- > 0;)
        add_row(rows_[i], i, frame);
    if (world != nullptr)
        add_foreground(scene, *world, canvas_.camera, canvas_.size(), motion.time());
}

// Draws the ground of a row, which reaches a little above the feet of its creatures, and these.
void FoundersPanel::add_row(const Row& row, std::size_t number, const FrameContext& frame) {
    const GridMotion& motion = frame.coach.founders->motion();
    if (number > 0 && motion.environment().has_ground) {
        const DrawnWorld* world =
            shown_world(frame.view, frame.window.scenery, motion.environment());
        const WorldWindow window = canvas_.camera.window(canvas_.size());
        const double pixel = canvas_.camera.pixel();
        const double top = row.lift + kMeadow * slot_;
        const double depth = top - rows_[number - 1].lift;
        const Color color = row_color(world, number);
        const Color near = row_color(world, number - 1);
        const Vec2 middle = 0.5 * (window.low + window.high);
        for (int band = 0; band < kBands; ++band) {
            const double share = static_cast<double>(band) / kBands;
            const double half = 0.5 * (1.0 - share) * depth;
            canvas_.frame.add_box({middle.x(), top - share * depth - half},
                                  {window.high.x() - middle.x() + pixel, half},
                                  mix(color, near, 0.85F * static_cast<float>(share)));
        }
        add_relief(row, top, color, *frame.coach.founders);
        if (world != nullptr) add_row_blades(canvas_.frame, *world, window, top, number, pixel);
    }
    // Shadows fall on the row's own ground.
    const GroundShape front =
        std::exchange(canvas_.frame.ground, shape_of_row(row, *frame.coach.founders));
    for (std::size_t place = row.first; place < row.first + row.count; ++place)
        add_founder(place, frame);
    canvas_.frame.ground = front;
}

void FoundersPanel::add_founder(std::size_t place, const FrameContext& frame) {
    const FounderCrowd& crowd = *frame.coach.founders;
    const RecordedMotion& recorded = crowd.motion().cell(place);
    if (recorded.empty()) return;
    const double time = crowd.motion().time();
    const bool ground = crowd.motion().environment().has_ground;
    MotionFrame shown = recorded.at(time);
    const double lift = rows_[row_of(place)].lift;
    const Vec2 by = shift_in_row(place, shown.center_of_mass.x(), crowd);
    for (Pose& pose : shown.poses) {
        pose.position.x() += by.x();
        pose.position.y() += by.y() - lift;
    }
    const Individual& founder = *crowd.founders()[place];
    Character character = character_of(recorded, ground, time);
    character.line = line_or_hue(founder.line, founder.genome->hue);
    const CreatureLook look{*recorded.phenotype, shown.poses,     {},       founder.genome->hue, {},
                            shown.stretches,     frame.view.look, character};
    SceneFrame& scene = canvas_.frame;
    const std::size_t shadows = scene.shapes.size();
    if (ground) add_shadow(scene, look);
    for (std::size_t i = shadows; i < scene.shapes.size(); ++i)
        scene.shapes[i].center.y() += lift;
    for (Pose& pose : shown.poses)
        pose.position.y() += lift;
    if (look.mode != LookMode::kMechanics)
        add_small_life(scene, moved_scuffs(recorded, time, by), time, crowd.motion().environment());
    add_being(scene, colors(), canvas_.camera, look);
}

// Marks the creature that the inspector describes.
void FoundersPanel::draw_choice(const FrameContext& frame) const {
    const FounderCrowd& crowd = *frame.coach.founders;
    const std::size_t place = frame.coach.founder;
    if (place >= crowd.founders().size() || crowd.motion().cell(place).empty()) return;
    const Vec2 top = top_of(place, crowd);
    const Vec2 at = canvas_.camera.to_screen(top, canvas_.size());
    const ImVec2 tip = {canvas_.area.x + static_cast<float>(at.x()),
                        canvas_.area.y + static_cast<float>(at.y()) - px(2)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddTriangleFilled({tip.x - px(6), tip.y - px(9)}, {tip.x + px(6), tip.y - px(9)}, tip,
                           paint(colors().accent));
    const std::string name = creature_name(*crowd.founders()[place]->genome);
    const WithFont font(ui().fonts.small);
    const ImVec2 size = ImGui::CalcTextSize(name.c_str());
    const ImVec2 low = {std::round(tip.x - 0.5F * size.x), std::round(tip.y - px(13) - size.y)};
    list.AddRectFilled({low.x - px(5), low.y - px(1)},
                       {low.x + size.x + px(5), low.y + size.y + px(1)},
                       paint(with_alpha(colors().panel, 0.85F)), px(4));
    list.AddText(low, paint(colors().text), name.c_str());
}

void FoundersPanel::draw_words(const FrameContext& frame) const {
    const FounderCrowd& crowd = *frame.coach.founders;
    const GoalKind* goal = frame.kinds.goals.find(crowd.settings()->goal);
    const std::string aim = goal == nullptr ? std::string("it") : uncapitalized(goal->label);
    const bool running = frame.experiment.snapshot.status == EngineStatus::kRunning;
    const std::string title =
        fmt::format("{} random creatures", kNumbers.at(crowd.founders().size()));
    const std::string words =
        running ? fmt::format("They are being judged at {}. The best of them takes the front.", aim)
                : fmt::format("Press Evolve, and watch their descendants get better at {}.", aim);
    const DrawnWorld* world =
        shown_world(frame.view, frame.window.scenery, crowd.motion().environment());
    const Palette& palette = world != nullptr ? palette_over(*world) : colors();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = {canvas_.area.x + px(16), canvas_.area.y + px(12)};
    const auto write = [&](ImFont* font, float size, float down, const std::string& text) {
        const ImVec2 place = {at.x, at.y + px(down)};
        list.AddText(font, px(size), {place.x, place.y + 1.0F},
                     paint(with_alpha(colors().sky, 0.9F)), text.c_str());
        list.AddText(font, px(size), place, paint(palette.text), text.c_str());
    };
    write(ui().fonts.title, 24.0F, 0.0F, title);
    write(ui().fonts.body, 16.0F, 32.0F, words);
}

}  // namespace cambrian
