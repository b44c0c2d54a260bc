#include "pictures/scene/moment.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "pictures/scene/bout_scene.h"
#include "pictures/scene/follow_camera.h"
#include "pictures/scene/hunter.h"
#include "pictures/scene/living_look.h"
#include "pictures/scene/scenery.h"
#include "pictures/scene/shaped_ground.h"
#include "pictures/scene/small_life.h"
#include "pictures/scene/space_moment.h"
#include "pictures/scene/stone_wall.h"
#include "simulator/contest/bout.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Frames between two looks at a body when its size is measured.
constexpr std::size_t kFramesALook = 3;
constexpr double kMarkPixels = 70.0;  // least distance of labelled ground marks, at label size 13
constexpr double kShareOfWidest = 0.66;  // bodies in space are hardly ever seen at their widest
constexpr double kTrailDot = 2.2;        // radius in pixels, at label size 13

// The cube and the opponent; their hues are left at 0.
BoutLook bodies_of(const RecordedMotion& motion, const BoutFrame& frame) {
    return {frame.cube, motion.opponent.get(), frame.opponent, frame.stretches};
}

// The rectangle of the world that contains all bodies.
WorldWindow window_of(const RecordedMotion& motion, const MotionFrame& frame) {
    const WorldWindow body = body_window(*motion.phenotype, frame.poses);
    return frame.bout ? with_bout(body, bodies_of(motion, *frame.bout)) : body;
}

Vec2 size_of_body(const RecordedMotion& motion, const MotionFrame& frame) {
    const WorldWindow window = window_of(motion, frame);
    return window.high - window.low;
}

// The point that the camera follows: the creature, or the middle of all bodies of a contest.
Vec2 middle_of(const RecordedMotion& motion, const MotionFrame& frame) {
    if (!frame.bout) return frame.center_of_mass.head<2>();
    const WorldWindow window = window_of(motion, frame);
    return 0.5 * (window.low + window.high);
}

Character character_at(const Subject& subject, const Moment& moment) {
    Character character =
        character_of(subject.motion(), subject.environment().has_ground, moment.time);
    character.line = line_or_hue(subject.creature.individual->line, subject.hue());
    const Vec2 here = moment.frame.center_of_mass.head<2>();
    if (moment.frame.light) look_at(character, here, moment.frame.light->head<2>());
    if (subject.motion().wall) look_at(character, here, subject.motion().wall->center.head<2>());
    return character;
}

double label_spacing(const Camera& camera, const MomentStyle& style) {
    return mark_spacing(camera, kMarkPixels * style.label_size / 13.0);
}

SceneFrame scene_of(const Subject& subject, const Moment& moment, const Camera& camera,
                    const Viewport& viewport, const MomentStyle& style) {
    const MotionFrame& shown = moment.frame;
    const bool marked = style.look != LookMode::kLife;  // with the faces that touch something
    const CreatureLook look{
        subject.phenotype(),
        shown.poses,
        marked ? std::span<const FaceSet>(shown.touched) : std::span<const FaceSet>(),
        subject.hue(),
        {},
        shown.stretches,
        style.look,
        character_at(subject, moment)};
    SceneFrame scene;
    scene.background = style.palette.sky;
    use_ground(scene, subject.environment(), camera, viewport);
    if (style.world != nullptr) {
        add_scenery(scene, *style.world, camera, viewport, moment.time);
    } else {
        add_grid(scene, style.palette, camera, viewport);
    }
    if (subject.environment().has_ground) {
        if (style.world == nullptr) add_ground(scene, style.palette, camera, viewport);
        add_shadow(scene, look);
    }
    scene.add_trail(subject.motion().trail(moment.time, style.trail),
                    kTrailDot * style.label_size / 13.0 * camera.pixel(),
                    with_alpha(style.palette.accent, 0.8F));
    if (style.look != LookMode::kMechanics)
        add_small_life(scene, subject.motion().scuffs, moment.time, subject.environment());
    if (subject.motion().wall) add_stone_wall(scene, *subject.motion().wall);
    if (shown.bout) {
        BoutLook bodies = bodies_of(subject.motion(), *shown.bout);
        bodies.hue = subject.creature.settings->world.opponents.hue_of_trial(0);
        bodies.beside = subject.hue();
        bodies.mode = style.look;
        bodies.time = moment.time;
        add_bout(scene, style.palette, camera, bodies);
    }
    if (shown.light) {
        const Vec2 place = shown.light->head<2>();
        if (style.world != nullptr)
            add_lamp(scene, camera, viewport, place, subject.environment().light_reach);
        if (subject.environment().light_motion == "hunting") {
            add_hunter(scene, place, shown.center_of_mass.head<2>(), moment.time);
        } else {
            add_light(scene, camera, viewport, place);
        }
    }
    add_being(scene, style.palette, camera, look);
    if (style.world != nullptr) add_foreground(scene, *style.world, camera, viewport, moment.time);
    return scene;
}

struct SeenGround {
    const Camera& camera;
    const Viewport& viewport;
    const GroundShape& ground;
};

// Labels each ground mark with its distance.
void add_ground_labels(PictureCanvas& canvas, const Area& area, const SeenGround& seen,
                       const MomentStyle& style) {
    const auto& [camera, viewport, ground] = seen;
    const WorldWindow window = camera.window(viewport);
    const double spacing = label_spacing(camera, style);
    const Ink ink{Typeface::kRegular, style.label_size, style.palette.muted};
    for (double i = std::ceil(window.low.x() / spacing); i * spacing < window.high.x(); i += 1.0) {
        const std::string label = with_unit(i * spacing, "m");
        const Vec2 at = camera.to_screen({i * spacing, ground.at(i * spacing)}, viewport);
        const double half =
            0.5 * canvas.text_rasterizer().width(label, ink.typeface, ink.size) + 4.0;
        const double base = at.y() + 1.75 * style.label_size;
        const bool inside = at.x() > half && at.x() < viewport.width - half &&
                            base < viewport.height - 0.3 * style.label_size;
        if (inside) canvas.add_text(area.x + at.x(), area.y + base, label, ink, Align::kMiddle);
    }
}

}  // namespace

Character character_of(const RecordedMotion& motion, bool walks, double time) {
    Character character;
    const Vec2 travelled =
        (motion.frames.back().center_of_mass - motion.frames.front().center_of_mass).head<2>();
    character.posture = motion.frames.front().poses;
    character.way = way_of(travelled, walks);
    character.walks = walks;
    character.time = time;
    follow_path(character, motion.trail(time, kPathPoints),
                motion.at(time).center_of_mass.head<2>(), body_size(*motion.phenotype));
    return character;
}

double scale_to_fit(const RecordedMotion& motion, const Area& area, double share) {
    Vec2 most = Vec2::Constant(0.01);
    if (motion.phenotype->plan.parts.front().half_extents.z() > 0.0)
        most = most.cwiseMax(Vec2::Constant(kShareOfWidest * widest_body(motion)));
    for (std::size_t i = 0; i < motion.frames.size(); i += kFramesALook)
        most = most.cwiseMax(size_of_body(motion, motion.frames[i]));
    Camera camera;
    camera.fit({Vec2::Zero(), most}, share, {area.width, area.height});
    return camera.pixels_per_metre;
}

std::vector<double> even_times(const RecordedMotion& motion, int count) {
    if (count == 1) return {0.5 * motion.length()};
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
        times.push_back(motion.length() * i / (count - 1));
    return times;
}

double telling_time(const RecordedMotion& motion) {
    const std::size_t count = motion.frames.size();
    std::size_t best = count / 2;
    for (std::size_t i = count / 4; i < count - count / 4; ++i) {
        if (size_of_body(motion, motion.frames[i]).prod() >
            size_of_body(motion, motion.frames[best]).prod())
            best = i;
    }
    return static_cast<double>(best * motion.stride) * kBrainTick;
}

// Rounds the time down to a recorded frame, so that the picture shows an exact tick.
Moment moment_of(const RecordedMotion& motion, double time) {
    if (motion.stride > 1) {
        const double step = static_cast<double>(motion.stride) * kBrainTick;
        const double last = static_cast<double>(motion.frames.size() - 1);
        time = std::min(std::floor(std::max(0.0, time) / step), last) * step;
    }
    return {time, motion.at(time)};
}

const DrawnWorld& world_of(const Subject& subject) {
    return drawn_world(world_kind_of(subject.environment()), Daytime::kNoon);
}

void add_moment(PictureCanvas& canvas, const Area& area, const Subject& subject,
                const Moment& moment, const MomentStyle& style) {
    if (subject.environment().dimensions == 3)
        return add_space_moment(canvas, area, subject, moment, style);
    const Viewport viewport{area.width, area.height};
    Camera camera;
    camera.pixels_per_metre = style.pixels_per_metre;
    const Environment& environment = subject.environment();
    Vec2 followed = middle_of(subject.motion(), moment.frame);
    if (style.along) followed.x() = *style.along;
    camera.center = follow_center(followed, environment, camera, viewport);
    const SceneFrame scene = scene_of(subject, moment, camera, viewport, style);
    canvas.add_scene(scene, camera, area);
    if (environment.has_ground && style.world == nullptr)
        add_ground_labels(canvas, area, {camera, viewport, scene.ground}, style);
}

std::string facts_line(const Subject& subject) {
    const Phenotype& phenotype = subject.phenotype();
    std::string facts = counted(phenotype.parts.size(), "part");
    for (const CountedMuscles& muscles : muscles_of(phenotype))
        facts += fmt::format("  ·  {}", counted(muscles.number, muscles.noun));
    return fmt::format("{}  ·  {}  ·  {}", facts, counted(phenotype.network.order.size(), "neuron"),
                       measured(subject.mass, "kg"));
}

}  // namespace cambrian
