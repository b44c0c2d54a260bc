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

SpaceCamera camera_at(const Vec3& target, const Area& area, const MomentStyle& style) {
    SpaceCamera camera;
    camera.look_from(kYaw, kPitch);
    camera.target = target;
    camera.pixels_per_metre = style.pixels_per_metre;
    camera.width = area.width;
    camera.height = area.height;
    return camera;
}

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

void add_space_moment(PictureCanvas& canvas, const Area& area, const Subject& subject,
                      const Moment& moment, const MomentStyle& style) {
    auto space = std::make_shared<SpaceFrame>();
    space->camera = camera_at(moment.frame.center_of_mass, area, style);
    space->samples = 2;
    SpaceLook world;
    world.plain = style.world != nullptr ? nullptr : &style.palette;
    world.time = moment.time;
    use_space(*space, subject.environment(), world);
    CreatureLook look{subject.phenotype(), moment.frame.poses};
    look.hue = subject.hue();
    look.mode = style.look;
    look.character.line = line_or_hue(subject.creature.individual->line, look.hue);
    look.character.posture = subject.motion().frames.front().poses;
    look.character.time = moment.time;
    SpaceManner manner;
    manner.way = space_way_of(subject.motion().frames.back().center_of_mass -
                              subject.motion().frames.front().center_of_mass);
    const std::vector<Vec3> path =
        path_of(subject.motion(), moment.time, std::max(style.trail, kPathPoints));
    follow_path(look.character, manner, path, moment.frame.center_of_mass,
                body_size(subject.phenotype()));
    add_being(*space, look, manner);
    const std::size_t shown = std::min(style.trail, path.size());
    for (std::size_t i = path.size() - shown; i < path.size(); ++i) {
        const float age =
            static_cast<float>(i + shown + 1 - path.size()) / static_cast<float>(shown);
        space->marks.push_back({.place = path[i],
                                .least = kTrailSize * style.label_size / 13.0,
                                .color = with_alpha(style.palette.accent, 0.8F * age)});
    }
    SceneFrame frame;
    frame.space = std::move(space);
    canvas.add_scene(std::move(frame), flat_camera(area), area);
}

}  // namespace cambrian
