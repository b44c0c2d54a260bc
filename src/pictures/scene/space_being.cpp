#include "pictures/scene/space_being.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cambrian {
namespace {

constexpr double kRoundShare = 0.5;    // of a part's least half extent that is round, if alive
constexpr double kBoxShare = 0.14;     // the same of plain boxes
constexpr double kMostRound = 0.09;    // m
constexpr double kMostBoxEdge = 0.02;  // m
constexpr float kGlassAlpha = 0.42F;

const Color kWhiteOfEye = color_of(0xFBF8F1);
const Color kDark = color_of(0x0F0E12);
const Color kLit = color_of(0xFFFFFF);

double edge_of(const Vec3& half, bool alive) {
    const double least = half.minCoeff();
    return alive ? std::min(kMostRound, kRoundShare * least)
                 : std::min(kMostBoxEdge, kBoxShare * least);
}

// Where eyes are on a part: on the edges between its front and its sides.
struct Head {
    std::size_t part = 0;
    Vec3 front = Vec3::UnitX();  // axes of the part, in its frame
    Vec3 side = Vec3::UnitY();
    Vec3 top = Vec3::UnitZ();
    double radius = 0.0;  // m, of an eye
};

const Pose& posture_of(const CreatureLook& look, std::size_t part) {
    return look.character.posture.empty() ? look.phenotype.plan.parts[part].rest_pose
                                          : look.character.posture[part];
}

// Returns the axis of a part, with its sign, that is nearest to a direction in the part's frame.
Vec3 nearest_axis(const Vec3& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    Vec3 result = Vec3::Zero();
    result[axis] = direction[axis] < 0.0 ? -1.0 : 1.0;
    return result;
}

// Chooses the part that is ahead of the others in the body's posture.
Head head_of(const CreatureLook& look, const Vec3& way) {
    const std::vector<PlannedPart>& parts = look.phenotype.plan.parts;
    const double size = body_size(look.phenotype);
    Vec3 middle = Vec3::Zero();
    double volume = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double share = parts[i].half_extents.prod();
        middle += share * posture_of(look, i).position;
        volume += share;
    }
    middle /= volume;
    Head head;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Pose& pose = posture_of(look, i);
        const Vec3& half = parts[i].half_extents;
        const Vec3 ahead = pose.orientation.conjugate() * way;
        const Vec3 away = pose.position - middle;
        const double aside = (away - away.dot(way) * way).norm();
        const bool thin = half.minCoeff() < 0.036 * size;
        const double merit =
            away.dot(way) + ahead.cwiseAbs().dot(half) - 0.9 * aside - (thin ? 1.5 * size : 0.0);
        if (merit > most + 1e-9) head.part = i;  // mirrored twins differ by rounding only
        most = std::max(most, merit);
    }
    const Vec3& half = parts[head.part].half_extents;
    head.front = nearest_axis(posture_of(look, head.part).orientation.conjugate() * way);
    // Eyes are at the ends of the wider of the two other axes.
    double widest = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (head.front[axis] != 0.0 || half[axis] <= widest) continue;
        widest = half[axis];
        head.side = Vec3::Unit(axis);
    }
    head.top = head.front.cross(head.side);
    const double narrow = std::min(widest, half.dot(head.top.cwiseAbs()));
    head.radius = std::min(std::clamp(0.5 * narrow, 0.055 * size, 0.12 * size), 0.95 * narrow);
    return head;
}

void add_ball(SpaceFrame& frame, const Vec3& at, double radius, const Color& fill, bool gleams,
              bool inked) {
    Solid ball;
    ball.pose.position = at;
    ball.half_extents = Vec3::Constant(radius);
    ball.radius = radius;
    ball.fill = fill;
    ball.shadows = false;
    ball.gleams = gleams;
    ball.inked = inked;
    frame.solids.push_back(ball);
}

void add_eyes(SpaceFrame& frame, const CreatureLook& look, const SpaceManner& manner) {
    const Head head = head_of(look, manner.way);
    const Vec3& half = look.phenotype.plan.parts[head.part].half_extents;
    const Pose& pose = look.poses[head.part];
    const Color lid = mix(
        skin_color(look.phenotype.parts[head.part], look.hue, look.character.line), kLit, 0.16F);
    const double radius = head.radius;
    const double reach = half.dot(head.front.cwiseAbs());
    const double width = half.dot(head.side.cwiseAbs());
    const double height = half.dot(head.top.cwiseAbs());
    for (const double sign : {1.0, -1.0}) {
        const Vec3 inside = (reach - 0.75 * radius) * head.front +
                            sign * (width - 0.35 * radius) * head.side +
                            std::max(0.0, 0.45 * height - 0.2 * radius) * head.top;
        const Vec3 at = transform(pose, inside);
        if (look.character.asleep || blinks(look.character)) {
            add_ball(frame, at, radius, lid, false, true);
            continue;
        }
        add_ball(frame, at, radius, kWhiteOfEye, true, true);
        const Vec3 turned = 0.75 * head.front + sign * 0.7 * head.side;
        const Vec3 ahead = pose.orientation * turned;
        const Vec3 gaze = (0.8 * manner.gaze + ahead).normalized();
        const double light = look.phenotype.sees ? 0.34 : 0.62;
        add_ball(frame, at + 0.50 * radius * gaze, 0.62 * radius,
                 color_of_hue(look.hue + 0.5, light, 0.12), true, false);
        add_ball(frame, at + 0.70 * radius * gaze, 0.47 * radius, kDark, true, false);
        const Vec3 up = pose.orientation * head.top;
        add_ball(frame, at + radius * (0.93 * gaze + 0.34 * up + 0.1 * ahead).normalized() * 1.07,
                 0.13 * radius, kLit, false, false);
    }
}

}  // namespace

void add_being(SpaceFrame& frame, const CreatureLook& look, const SpaceManner& manner) {
    const bool alive = look.mode != LookMode::kMechanics;
    const float alpha = manner.alpha * (look.mode == LookMode::kGlass ? kGlassAlpha : 1.0F);
    const double size = body_size(look.phenotype);
    for (std::size_t i = 0; i < look.poses.size(); ++i) {
        const BodyPart& part = look.phenotype.parts[i];
        Solid solid;
        solid.pose = look.poses[i];
        solid.half_extents = look.phenotype.plan.parts[i].half_extents;
        solid.radius = edge_of(solid.half_extents, alive);
        solid.fill =
            alive ? skin_color(part, look.hue, look.character.line) : part_color(part, look.hue);
        if (look.highlight.covers(i, part)) solid.fill = mix(solid.fill, kLit, 0.35F);
        solid.fill.a = alpha;
        if (alive) {
            solid.pattern = pattern_of(look.character.line);
            solid.wave = size * wave_of(look.character.line);
            solid.phase = 0.37F * static_cast<float>(i);
        }
        frame.solids.push_back(solid);
    }
    if (look.mode == LookMode::kLife && alpha >= 1.0F) add_eyes(frame, look, manner);
}

Vec3 space_way_of(const Vec3& travelled) {
    constexpr double kTelling = 0.3;  // m; less says nothing of its way
    if (travelled.norm() < kTelling) return Vec3::UnitX();
    return travelled.normalized();
}

void follow_path(Character& character, SpaceManner& manner, std::span<const Vec3> path,
                 const Vec3& here, double size) {
    constexpr double kPathRate = 15.0;  // points a second
    constexpr std::size_t kGlance = 5;  // points; a third of a second
    constexpr std::size_t kRest = 45;   // points; 3 s
    constexpr double kSwift = 0.3;      // body sizes a second, at which it looks along its way
    if (path.size() >= kGlance) {
        const Vec3 velocity =
            (here - path[path.size() - kGlance]) * (kPathRate / static_cast<double>(kGlance));
        const double speed = velocity.norm();
        if (speed > 0.0) manner.gaze = std::min(1.0, speed / (kSwift * size)) / speed * velocity;
    }
    if (path.size() < kRest) return;
    character.asleep = std::all_of(path.end() - kRest, path.end(), [&](const Vec3& point) {
        return (point - here).norm() < 0.02 * size;
    });
}

PartHit part_at(const Phenotype& phenotype, std::span<const Pose> poses, const SpaceCamera& camera,
                const Vec2& pixel) {
    const Vec3 eye = camera.place();
    const Vec3 way = camera.direction(pixel.x(), pixel.y());
    PartHit hit;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const Vec3& half = phenotype.plan.parts[i].half_extents;
        const Vec3 from = poses[i].orientation.conjugate() * Vec3(eye - poses[i].position);
        const Vec3 along = poses[i].orientation.conjugate() * way;
        double enter = 0.0;
        double leave = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            if (along[axis] == 0.0) {
                if (std::fabs(from[axis]) > half[axis]) leave = -1.0;
                continue;
            }
            const double one = (-half[axis] - from[axis]) / along[axis];
            const double other = (half[axis] - from[axis]) / along[axis];
            enter = std::max(enter, std::min(one, other));
            leave = std::min(leave, std::max(one, other));
        }
        if (enter > leave || enter >= nearest) continue;
        nearest = enter;
        hit = {static_cast<int>(i), eye + enter * way};
    }
    return hit;
}

void add_corners(std::vector<Vec3>& corners, const Phenotype& phenotype,
                 std::span<const Pose> poses) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const Vec3& half = phenotype.plan.parts[i].half_extents;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Vec3 signs((corner & 1U) != 0 ? 1.0 : -1.0, (corner & 2U) != 0 ? 1.0 : -1.0,
                             (corner & 4U) != 0 ? 1.0 : -1.0);
            corners.push_back(transform(poses[i], signs.cwiseProduct(half)));
        }
    }
}

}  // namespace cambrian
