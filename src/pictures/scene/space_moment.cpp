#include "pictures/scene/space_moment.h"

#include "math/angle.h"
#include "pictures/scene/space_being.h"
#include "pictures/scene/space_world.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr double kYaw = to_radians(32.0);
constexpr double kPitch = to_radians(20.0);
constexpr double kTrailSize = 2.4;  // pixels, at label size 13
constexpr std::size_t kFramesADot = 4;
constexpr std::size_t kFramesALength = 3;

// The planar camera of shapes over the solids: one metre of theirs is one pixel.
Camera flat_camera(const Area& area) {
    Camera flat;
    flat.pixels_per_metre = 1.0;
    flat.center = {0.5 * area.width, -0.5 * area.height};
    return flat;
}

// The last places of the centre of mass, fifteen a second, oldest first, as far as every frame of
// it is known.
std::vector<Vec3> path_of(const RecordedMotion& motion, double time, std::size_t points) {
    std::vector<Vec3> path;
    if (motion.stride > 1) return path;
    const auto now = std::min(static_cast<std::size_t>(std::max(0.0, time / kBrainTick)),
                              motion.frames.size() - 1);
    for (std::size_t dot = std::min(now / kFramesADot, points); dot > 0; --dot)
        path.push_back(motion.frames[(now / kFramesADot - dot + 1) * kFramesADot].center_of_mass);
    return path;
}

}  // namespace

double widest_body(const RecordedMotion& motion) {
    double widest = 0.02;
    for (std::size_t i = 0; i < motion.frames.size(); i += kFramesALength) {
        const MotionFrame& frame = motion.frames[i];
        for (std::size_t part = 0; part < frame.poses.size(); ++part) {
            const double reach = motion.phenotype->plan.parts[part].half_extents.norm();
            const Vec3 arm = frame.poses[part].position - frame.center_of_mass;
            widest = std::max(widest, 2.0 * (arm.norm() + reach));
        }
    }
    return widest;
}

SpaceFrame space_frame(const SpaceInstant& instant) {
    const RecordedMotion& motion = instant.motion;
    SpaceFrame frame;
    frame.camera.look_from(instant.along ? 0.0 : kYaw, kPitch);
    frame.camera.target = instant.shown.center_of_mass;
    if (instant.along) frame.camera.target.x() = *instant.along;
    frame.camera.pixels_per_metre = instant.pixels_per_metre;
    frame.camera.width = instant.size.width;
    frame.camera.height = instant.size.height;
    frame.samples = instant.samples;
    SpaceLook surroundings = instant.surroundings;
    surroundings.time = instant.time;
    use_space(frame, instant.environment, surroundings);
    CreatureLook look{*motion.phenotype, instant.shown.poses};
    look.hue = instant.creature.genome->hue;
    look.mode = instant.look;
    look.character.line = line_or_hue(instant.creature.line, look.hue);
    look.character.posture = motion.frames.front().poses;
    look.character.time = instant.time;
    SpaceManner manner;
    manner.way =
        space_way_of(motion.frames.back().center_of_mass - motion.frames.front().center_of_mass);
    const std::vector<Vec3> path =
        path_of(motion, instant.time, std::max(instant.trail, kPathPoints));
    follow_path(look.character, manner, path, instant.shown.center_of_mass,
                body_size(*motion.phenotype));
    add_being(frame, look, manner);
    const std::size_t shown = std::min(instant.trail, path.size());
    for (std::size_t i = path.size() - shown; i < path.size(); ++i) {
        const std::size_t age = i + shown + 1 - path.size();
        const float fresh = static_cast<float>(age) / static_cast<float>(shown);
        frame.marks.push_back({.place = path[i],
                               .least = instant.trail_dot,
                               .color = with_alpha(instant.trail_color, 0.8F * fresh)});
    }
    return frame;
}

void add_space_moment(PictureCanvas& canvas, const Area& area, const Subject& subject,
                      const Moment& moment, const MomentStyle& style) {
    SpaceLook surroundings;
    surroundings.plain = style.world != nullptr ? nullptr : &style.palette;
    SceneFrame frame;
    frame.space = std::make_shared<const SpaceFrame>(
        space_frame({.motion = subject.motion(),
                     .shown = moment.frame,
                     .time = moment.time,
                     .environment = subject.environment(),
                     .creature = *subject.creature.individual,
                     .surroundings = surroundings,
                     .look = style.look,
                     .size = {area.width, area.height},
                     .pixels_per_metre = style.pixels_per_metre,
                     .trail = style.trail,
                     .trail_color = style.palette.accent,
                     .trail_dot = kTrailSize * style.label_size / 13.0,
                     .samples = 2,
                     .along = style.along}));
    canvas.add_scene(std::move(frame), flat_camera(area), area);
}

}  // namespace cambrian
