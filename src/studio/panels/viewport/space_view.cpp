#include "studio/panels/viewport/space_view.h"

#include "pictures/scene/space_world.h"
#include "studio/panels/viewport/space_overlays.h"
#include "studio/panels/viewport/viewport_tools.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr double kOrbitLag = 0.25;      // s; time constant with which the camera follows
constexpr double kRiseShare = 0.3;      // of that speed, with which it follows up and down
constexpr double kMostBehind = 0.30;    // of the view's height, by which it stays behind
constexpr double kFitBodyShare = 0.46;  // of the view, filled by a body that is fit into it
constexpr double kTrailPixels = 2.2;

Vec2 mouse_in(const SceneCanvas& canvas) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {static_cast<double>(mouse.x - canvas.area.x),
            static_cast<double>(mouse.y - canvas.area.y)};
}

// Returns where the ray through a pixel meets the plane parallel to the picture through a point.
Vec3 in_plane_of(const SpaceCamera& camera, const Vec2& pixel, double depth) {
    const Vec3 way = camera.direction(pixel.x(), pixel.y());
    return camera.place() + (camera.distance() - depth) / camera.distance() * way;
}

}  // namespace

Vec2 SpaceView::on_canvas(const Vec3& point, const SceneCanvas& canvas) const {
    return in_picture(orbit_.seen(canvas.size()), point);
}

void SpaceView::stop_following(const FrameContext& frame, Requests& out) const {
    if (!frame.view.follow) return;
    ViewState view = frame.view;
    view.follow = false;
    out.ask(ChangeView{view});
}

void SpaceView::handle_mouse(const FrameContext& frame, const SceneCanvas& canvas, Requests& out) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    const Viewport viewport = canvas.size();
    const Vec2 moved(static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y));
    if (hovered && io.MouseWheel != 0.0F) {
        const Vec2 middle = 0.5 * Vec2(viewport.width, viewport.height);
        orbit_.zoom_about(frame.view.follow ? middle : mouse_in(canvas),
                          std::pow(kNotchFactor, static_cast<double>(io.MouseWheel)), viewport);
    }
    turning_ = turning_ && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (active && (ImGui::IsMouseDragging(ImGuiMouseButton_Right) ||
                   (turning_ && ImGui::IsMouseDragging(ImGuiMouseButton_Left))))
        orbit_.orbit(moved);
    if (active && ImGui::IsMouseDragging(ImGuiMouseButton_Middle)) {
        orbit_.pan(moved, viewport);
        stop_following(frame, out);
    }
    handle_poke(frame, canvas, out);
    if (!hovered) return;
    const PlayedCreature& creature = frame.viewer.playback.creature();
    const int under = part_at(creature.phenotype(), creature.motion().poses(),
                              orbit_.seen(viewport), mouse_in(canvas))
                          .part;
    if (under >= 0) out.ask(ShowHighlight{{.part = under}});
}

// The left button grabs the part under the mouse and pulls it in the plane parallel to the picture
// while held.
void SpaceView::handle_poke(const FrameContext& frame, const SceneCanvas& canvas, Requests& out) {
    const SpaceCamera camera = orbit_.seen(canvas.size());
    const PlayedCreature& creature = frame.viewer.playback.creature();
    if (const Hold* hold = creature.hold()) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
            out.ask(PokePart{hold->part, hold->point_in_part,
                             in_plane_of(camera, mouse_in(canvas), grabbed_)});
        } else {
            out.ask(ReleasePoke{});
        }
        return;
    }
    if (!ImGui::IsItemActive() || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    const PartHit hit =
        part_at(creature.phenotype(), creature.motion().poses(), camera, mouse_in(canvas));
    turning_ = hit.part < 0;
    if (turning_) return;
    grabbed_ = (hit.place - camera.target).dot(camera.back);
    const auto part = static_cast<std::size_t>(hit.part);
    const Pose& pose = creature.motion().poses()[part];
    out.ask(
        PokePart{part, pose.orientation.conjugate() * Vec3(hit.place - pose.position), hit.place});
}

void SpaceView::look_from(ViewSide side) {
    switch (side) {
        case ViewSide::kSlanted:
            orbit_.yaw = OrbitCamera{}.yaw;
            orbit_.pitch = OrbitCamera{}.pitch;
            break;
        case ViewSide::kFront:
            return orbit_.look_from(Vec3::UnitZ());
        case ViewSide::kRight:
            return orbit_.look_from(Vec3::UnitX());
        case ViewSide::kTop:
            return orbit_.look_from(Vec3::UnitY());
    }
}

void SpaceView::place_camera(const FrameContext& frame, const SceneCanvas& canvas, bool changed,
                             bool fit) {
    const Viewport viewport = canvas.size();
    const PlayedCreature& creature = frame.viewer.playback.creature();
    const Vec3 center = creature.motion().center();
    std::vector<Vec3> corners;
    add_corners(corners, creature.phenotype(), creature.motion().poses());
    if (std::exchange(sides_seen_, frame.viewer.sides_asked) != frame.viewer.sides_asked)
        look_from(frame.viewer.side);
    if (changed && frame.view.follow) orbit_.target = center;
    const double share = orbit_.share_of(corners, viewport);
    // A new creature keeps the distance, so that sizes can be compared, unless it would not be
    // visible.
    if (fit || (changed && (share > 0.8 || share < 0.2))) {
        orbit_.fit(corners, kFitBodyShare, viewport);
        if (frame.view.follow) orbit_.target = center;
    } else if (frame.view.follow && !changed) {
        Vec3 wanted = center;
        wanted.y() = orbit_.target.y() + kRiseShare * (center.y() - orbit_.target.y());
        orbit_.approach(wanted, static_cast<double>(ImGui::GetIO().DeltaTime), kOrbitLag,
                        kMostBehind * viewport.height / orbit_.seen(viewport).pixels_per_metre);
    }
}

void SpaceView::build_scene(const FrameContext& frame, SceneCanvas& canvas) const {
    const Playback& playback = frame.viewer.playback;
    const PlayedCreature& creature = playback.creature();
    const Environment& environment = creature.replay().environment();
    const Viewport viewport = canvas.size();
    const Palette& palette = colors();
    auto space = std::make_shared<SpaceFrame>();
    space->camera = orbit_.seen(viewport);
    const bool plain =
        frame.window.scenery == Scenery::kPlain || frame.view.look == LookMode::kMechanics;
    SpaceLook look_of_world;
    look_of_world.daytime = daytime_of(frame.view.theme);
    look_of_world.plain = plain ? &palette : nullptr;
    look_of_world.grid = plain ? frame.view.overlays.grid : frame.view.overlays.ruler;
    look_of_world.time = playback.trial().time();
    use_space(*space, environment, look_of_world);
    if (frame.window.scenery == Scenery::kLight && space->floor) space->floor->ripples = 0.0F;

    std::vector<FaceSet> touched;
    if (frame.view.overlays.contacts) touched = touched_faces(playback.trial().scene());
    CreatureLook look{creature.phenotype(),
                      creature.motion().poses(),
                      touched,
                      playback.exhibit().genome()->hue,
                      frame.viewer.highlight,
                      {},
                      shown_look(frame)};
    const Individual& individual = playback.exhibit().individual();
    look.character.line = line_or_hue(individual.line, individual.genome->hue);
    look.character.posture = creature.readings().posture();
    look.character.time = playback.trial().time();
    SpaceManner manner;
    if (frame.viewer.score != nullptr && !frame.viewer.score->record.samples.empty()) {
        const std::vector<MotionSample>& samples = frame.viewer.score->record.samples;
        manner.way = space_way_of(samples.back().center_of_mass - samples.front().center_of_mass);
    }
    follow_path(look.character, manner, creature.readings().trail_in_space(),
                creature.motion().center(), body_size(creature.phenotype()));
    add_being(*space, look, manner);
    for (const auto& ghost : frame.viewer.ghosts) {
        CreatureLook pale{ghost->phenotype(), ghost->poses(), {}, ghost->genome().hue, {}, {},
                          frame.view.look};
        pale.character.line = line_or_hue(ghost->line(), ghost->genome().hue);
        add_being(*space, pale, {.alpha = 0.3F});
    }
    if (frame.view.overlays.trail) {
        const std::span<const Vec3> path = creature.readings().trail_in_space();
        for (std::size_t i = 0; i < path.size(); ++i) {
            const float age = static_cast<float>(i + 1) / static_cast<float>(path.size());
            space->marks.push_back({.place = path[i],
                                    .least = kTrailPixels,
                                    .color = with_alpha(palette.accent, 0.8F * age)});
        }
    }
    const SpaceCamera camera = space->camera;
    canvas.frame.space = std::move(space);
    canvas.camera.pixels_per_metre = 1.0;
    canvas.camera.center = {0.5 * viewport.width, -0.5 * viewport.height};
    add_overlays(frame, camera, look, canvas.frame);
}

void SpaceView::add_overlays(const FrameContext& frame, const SpaceCamera& camera,
                             const CreatureLook& look, SceneFrame& scene) const {
    const OverlaysShown& shown = frame.view.overlays;
    const Trial& trial = frame.viewer.playback.trial();
    const PlayedCreature& creature = frame.viewer.playback.creature();
    const bool has_ground = creature.replay().environment().has_ground;
    const OverlayScene over{
        look, trial.scene(), trial.creature(), trial.surroundings(), frame.kinds.creature, colors(),
        1.0};
    add_touched_faces(scene, camera, look,
                      with_alpha(colors().plot_best, look.mode == LookMode::kLife ? 0.6F : 1.0F));
    if (look.mode == LookMode::kGlass) add_edges(scene, camera, look, colors().text);
    if (look.mode != LookMode::kLife) add_joint_axes(scene, camera, over, !shown.limits);
    if (shown.limits) add_joint_limits(scene, camera, over);
    if (shown.torques) add_joint_torques(scene, camera, over);
    if (shown.sensors) add_sensor_readings(scene, camera, over);
    if (shown.forces) add_contact_forces(scene, camera, over);
    if (shown.center_of_mass)
        add_center_of_mass(scene, camera, creature.motion().center(), has_ground);
    const Hold* hold = creature.hold();
    const auto& poses = creature.motion().poses();
    if (hold == nullptr || hold->part >= poses.size()) return;
    add_line(scene, camera, transform(poses[hold->part], hold->point_in_part), hold->target, 2.0,
             colors().danger);
}

}  // namespace cambrian
