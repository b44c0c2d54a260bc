#include "pictures/scene/living_look.h"

#include "pictures/scene/organ_features.h"
#include "pictures/scene/organ_marks.h"
#include "pictures/scene/shown_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kRoundness = 0.62F;  // of corners
constexpr double kFoot = 0.10;       // body sizes; lower corners are nearly sharp
constexpr float kFootRoundness = 0.12F;
constexpr float kGlass = 0.45F;
constexpr float kPale = 0.3F;
constexpr double kLeastEye = 1.2;  // pixels; radius

const Color kWhite = color_of(0xFFFFFF);
const Color kEyeWhite = color_of(0xFBF8F1);
const Color kEyeEdge = color_of(0x1A1416);
const Color kPupil = color_of(0x0F0E12);

Vec2 shown_half_of(const CreatureLook& look, std::size_t part) {
    return shown_half_extents(look.phenotype.plan, look.stretches, part).head<2>();
}

Vec2 world_point(const CreatureLook& look, std::size_t part, const Vec2& at) {
    const Vec3 shown = shown_point({at.x(), at.y(), 0.0}, look.stretches, part);
    return transform(look.poses[part], shown).head<2>();
}

// Corners near the ground are filled up, so that a body touches where physics touches.
float roundness_at(const CreatureLook& look, const Pose& pose, const Vec2& corner, double size) {
    if (!look.character.walks) return kRoundness;
    const double height = transform(pose, {corner.x(), corner.y(), 0.0}).y();
    const auto near = static_cast<float>(std::clamp(1.0 - height / (kFoot * size), 0.0, 1.0));
    return kRoundness + (kFootRoundness - kRoundness) * near;
}

// Returns the mean of all parts' smaller half extents, weighted by their areas, in m.
double usual_half_width(const Phenotype& phenotype) {
    double sum = 0.0;
    double area = 0.0;
    for (const PlannedPart& part : phenotype.plan.parts) {
        const Vec2 half = part.half_extents.head<2>();
        sum += half.minCoeff() * half.prod();
        area += half.prod();
    }
    return sum / area;
}

SkinBox skin_box(const CreatureLook& look, std::size_t index, double size) {
    const Pose& pose = look.poses[index];
    SkinBox box;
    box.center = pose.position.head<2>();
    box.half_extents = shown_half_of(look, index);
    box.angle = planar_angle(pose);
    std::size_t corner = 0;
    for (const double y : {box.half_extents.y(), -box.half_extents.y()}) {
        for (const double x : {box.half_extents.x(), -box.half_extents.x()})
            box.roundness[corner++] = roundness_at(look, pose, {x, y}, size);
    }
    box.fill = skin_color(look.phenotype.parts[index], look.hue, look.character.line);
    if (look.highlight.covers(index, look.phenotype.parts[index]))
        box.fill = mix(box.fill, kWhite, 0.18F);
    box.phase = 0.37F * static_cast<float>(index);
    return box;
}

// Draws the true boxes of parts: of all, or of the highlighted ones.
void add_outlines(SceneFrame& frame, const CreatureLook& look, double pixel, bool all) {
    for (std::size_t i = look.poses.size(); i-- > 0;) {
        const bool lit = look.highlight.covers(i, look.phenotype.parts[i]);
        if (!lit && !all) continue;
        Shape shape;
        shape.center = look.poses[i].position.head<2>();
        shape.half_extents = shown_half_of(look, i);
        shape.angle = planar_angle(look.poses[i]);
        shape.radius = 0.45 * shape.half_extents.minCoeff();
        shape.outline_width = std::max((lit ? 2.0 : 1.5) * pixel, lit ? 0.010 : 0.008);
        shape.fill = with_alpha(kWhite, 0.0F);
        const Color edge = part_color(look.phenotype.parts[i], look.hue);
        shape.outline = lit ? kWhite : with_alpha(edge, 0.9F);
        frame.shapes.push_back(shape);
    }
}

// Small dimples where parts are joined.
void add_dimples(SceneFrame& frame, const CreatureLook& look, double pixel) {
    const double most = 0.03 * body_size(look.phenotype);
    for (const auto& [index, degree] : look.phenotype.effectors) {
        if (degree > 0) continue;
        const PlannedPart& part = look.phenotype.plan.parts[index];
        const double radius = std::min(most, 0.3 * part.half_extents.head<2>().minCoeff());
        if (radius < 1.6 * pixel) continue;
        const Vec2 at = world_point(look, index, part.anchor_in_child.head<2>());
        frame.add_circle(at, radius, color_of(0x140E10, 0.34F));
        frame.add_circle(at - Vec2(0.0, 0.22 * radius), 0.62 * radius, color_of(0xFFF6E8, 0.22F));
    }
}

// Returns the direction in which the head points now.
Vec2 ahead_of(const CreatureLook& look, std::size_t head) {
    const Character& character = look.character;
    if (character.walks) return Vec2(character.way + Vec2(0.0, -0.1)).normalized();
    const Pose& before = character.posture.empty() ? look.phenotype.plan.parts[head].rest_pose
                                                   : character.posture[head];
    const auto [sine, cosine] = sine_cosine(planar_angle(look.poses[head]) - planar_angle(before));
    const Vec2& way = character.way;
    return {cosine * way.x() - sine * way.y(), sine * way.x() + cosine * way.y()};
}

void add_eye(SceneFrame& frame, const CreatureLook& look, const Eyes& eyes, std::size_t which,
             double pixel) {
    const Character& character = look.character;
    const Vec2 at = world_point(look, eyes.part, eyes.places[which]);
    const double radius = eyes.radii[which];
    const BodyPart& part = look.phenotype.parts[eyes.part];
    Shape ball;
    ball.center = at;
    ball.half_extents = Vec2::Constant(radius);
    ball.radius = radius;
    ball.outline_width = std::max(pixel, 0.13 * radius);
    ball.outline = kEyeEdge;
    if (character.asleep || blinks(character)) {
        ball.fill = mix(skin_color(part, look.hue, character.line), kWhite, 0.16F);
        frame.shapes.push_back(ball);
        const Vec2 along = transform(look.poses[eyes.part], Vec3::Zero()).head<2>();
        const Vec2 level = character.walks ? Vec2(1.0, 0.0) : Vec2(at - along).normalized();
        const Vec2 lid = 0.72 * radius * (character.walks ? level : Vec2(-level.y(), level.x()));
        const Vec2 low = at - Vec2(0.0, 0.15 * radius);
        frame.add_line(low - lid, low + lid, std::max(pixel, 0.16 * radius), kEyeEdge);
        return;
    }
    ball.fill = kEyeWhite;
    frame.shapes.push_back(ball);
    // What is left of its attention goes ahead.
    const Vec2 gaze = character.gaze + (1.0 - character.gaze.norm()) * ahead_of(look, eyes.part);
    const Vec2 iris = at + 0.27 * radius * gaze;
    const double light = look.phenotype.sees ? 0.34 : 0.66;
    frame.add_circle(iris, 0.56 * radius, color_of_hue(look.hue + 0.5, light, 0.11));
    frame.add_circle(iris + 0.04 * radius * gaze, 0.38 * radius, kPupil);
    frame.add_circle(iris + Vec2(0.17, 0.20) * radius, std::max(0.15 * radius, 0.4 * pixel),
                     with_alpha(kWhite, 0.95F));
}

void add_eyes(SceneFrame& frame, const CreatureLook& look, double pixel) {
    const Eyes eyes = eyes_of(look.phenotype, look.character);
    if (eyes.radii[0] < kLeastEye * pixel) return;
    add_eye(frame, look, eyes, 1, pixel);
    add_eye(frame, look, eyes, 0, pixel);
}

}  // namespace

void add_skin_of(SceneFrame& frame, const Camera& camera, const CreatureLook& look, float alpha) {
    const double pixel = camera.pixel();
    const double size = body_size(look.phenotype);
    for (std::size_t i = 0; i < look.poses.size(); ++i)
        frame.skin_boxes.push_back(skin_box(look, i, size));
    Skin skin;
    skin.boxes = look.poses.size();
    skin.blend = std::clamp(std::min(0.11 * size, 1.6 * usual_half_width(look.phenotype)),
                            1.2 * pixel, 60.0 * pixel);
    skin.outline_width = std::clamp(0.018 * size, 0.8 * pixel, 4.5 * pixel);
    skin.wave = size * wave_of(look.character.line);
    skin.pattern = pattern_of(look.character.line);
    skin.crease = alpha < 1.0F || size < 40.0 * pixel ? 0.0F : 1.0F;
    skin.flash = look.bitten ? 0.35F : 0.0F;
    skin.alpha = alpha;
    frame.add_skin(skin);
}

void add_being(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const CreatureLook& look) {
    const double pixel = camera.pixel();
    if (look.mode == LookMode::kMechanics) return add_creature(frame, palette, camera, look);
    const bool glass = look.mode == LookMode::kGlass;
    add_skin_of(frame, camera, look, glass ? kGlass : 1.0F);
    add_outlines(frame, look, pixel, glass);
    add_touched(frame, with_alpha(palette.plot_best, glass ? 1.0F : 0.6F), camera, look);
    if (glass) {
        add_organ_marks(frame, look.phenotype, look.poses, look.stretches, pixel);
        add_joints(frame, camera, look);
    } else {
        add_organ_features(frame, look, pixel);
        add_dimples(frame, look, pixel);
        add_eyes(frame, look, pixel);
    }
}

void add_pale_being(SceneFrame& frame, const Camera& camera, const CreatureLook& look) {
    if (look.mode == LookMode::kMechanics) return add_ghost(frame, camera, look);
    add_skin_of(frame, camera, look, kPale);
}

}  // namespace cambrian
