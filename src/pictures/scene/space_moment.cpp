#include "pictures/scene/space_moment.h"

#include "core/hash.h"
#include "math/angle.h"
#include "pictures/scene/scene_builder.h"
#include "render/solid_painter.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr double kYaw = to_radians(32.0);
constexpr double kPitch = to_radians(20.0);
constexpr double kEdgeShare = 0.42;     // of a part's least half extent that is round
constexpr double kMostEdge = 0.045;     // m
constexpr double kSpeckSpacing = 0.55;  // m; one speck in each cube of the water
constexpr int kSpeckCubes = 6;          // to each side of the creature
constexpr double kSpeckSize = 0.007;    // m
constexpr double kTrailSize = 2.4;      // pixels, at label size 13
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

// The planar camera of the shapes behind the solids: one metre of theirs is one pixel.
Camera flat_camera(const SpaceCamera& camera) {
    Camera flat;
    flat.pixels_per_metre = 1.0;
    flat.center = {0.5 * camera.width, -0.5 * camera.height};
    return flat;
}

// A number in [0, 1) that belongs to a cube of the water.
double cube_number(int x, int y, int z, std::uint64_t salt) {
    Hash64 hash;
    for (const int number : {x, y, z})
        hash.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(number)));
    hash.add(salt);
    return static_cast<double>(hash.value() >> 11U) * 0x1p-53;
}

// Specks that hang in the water show how the creature moves through it.
void add_hanging_specks(SceneFrame& frame, const SpaceCamera& camera, const Color& color) {
    const auto cube_of = [](double place) {
        return static_cast<int>(std::floor(place / kSpeckSpacing));
    };
    const int at[3] = {cube_of(camera.target.x()), cube_of(camera.target.y()),
                       cube_of(camera.target.z())};
    for (int i = at[0] - kSpeckCubes; i <= at[0] + kSpeckCubes; ++i) {
        for (int j = at[1] - kSpeckCubes; j <= at[1] + kSpeckCubes; ++j) {
            for (int k = at[2] - kSpeckCubes; k <= at[2] + kSpeckCubes; ++k) {
                const Vec3 place(i + cube_number(i, j, k, 1), j + cube_number(i, j, k, 2),
                                 k + cube_number(i, j, k, 3));
                const SpaceCamera::Seen seen = camera.look_at(kSpeckSpacing * place);
                if (seen.distance < 0.4 * camera.distance()) continue;
                const double scale = camera.pixels_per_metre * camera.distance() / seen.distance;
                const double depth = seen.distance / camera.distance();
                const double faint = std::clamp(1.7 - depth, 0.0, 0.75);
                const double size = kSpeckSize * (0.5 + cube_number(i, j, k, 4));
                frame.add_circle({seen.place.x(), -seen.place.y()}, std::max(0.6, scale * size),
                                 with_alpha(color, static_cast<float>(faint)));
            }
        }
    }
}

// The way of the centre of mass, as far as every frame of it is known.
void add_way(SceneFrame& frame, const SpaceCamera& camera, const RecordedMotion& motion,
             double time, const MomentStyle& style) {
    if (motion.stride > 1) return;
    const auto now = std::min(static_cast<std::size_t>(std::max(0.0, time / kBrainTick)),
                              motion.frames.size() - 1);
    std::vector<Vec2> dots;
    for (std::size_t dot = std::min(now / kFramesADot, style.trail); dot > 0; --dot) {
        const std::size_t frame_number = (now / kFramesADot - dot + 1) * kFramesADot;
        const Vec2 place = camera.look_at(motion.frames[frame_number].center_of_mass).place;
        dots.emplace_back(place.x(), -place.y());
    }
    frame.add_trail(dots, kTrailSize * style.label_size / 13.0,
                    with_alpha(style.palette.accent, 0.8F));
}

std::vector<Solid> solids_of(const Subject& subject, const MotionFrame& shown) {
    const Phenotype& phenotype = subject.phenotype();
    std::vector<Solid> solids;
    for (std::size_t i = 0; i < shown.poses.size(); ++i) {
        const Vec3& half = phenotype.plan.parts[i].half_extents;
        solids.push_back({shown.poses[i], half, std::min(kMostEdge, kEdgeShare * half.minCoeff()),
                          part_color(phenotype.parts[i], subject.hue())});
    }
    return solids;
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
    const SpaceCamera camera = camera_at(moment.frame.center_of_mass, area, style);
    const DrawnWorld& world = style.world != nullptr ? *style.world : world_of(subject);
    SceneFrame frame;
    frame.background = style.palette.sky;
    use_world(frame, world);
    add_hanging_specks(frame, camera, world.specks.a > 0.0F ? world.specks : style.palette.text);
    add_way(frame, camera, subject.motion(), moment.time, style);
    canvas.add_scene(std::move(frame), flat_camera(camera), area);
    SpaceLight light;
    light.above = color_of(0xDDF3F5);
    light.below = color_of(0x2F6675);
    light.haze = color_of(0x2B7F96);
    light.haze_depth = 2.0 * camera.distance();
    auto solids = std::make_shared<const std::vector<Solid>>(solids_of(subject, moment.frame));
    canvas.add_touch([area, camera, light, solids](Image& image) {
        paint_solids(image, static_cast<int>(std::lround(area.x)),
                     static_cast<int>(std::lround(area.y)), camera, light, *solids);
    });
}

}  // namespace cambrian
