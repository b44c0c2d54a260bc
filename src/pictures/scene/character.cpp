#include "pictures/scene/character.h"

#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr std::uint64_t kLightnesses = 3;
constexpr double kBlinkPeriod = 3.5;  // s
constexpr double kBlink = 0.13;       // s

Vec2 across(const Vec2& way) {
    return {-way.y(), way.x()};
}

// A part as it is in the posture by which eyes are placed.
struct PosedPart {
    Vec2 half;   // m
    Vec2 place;  // m
    SineCosine turn;

    // Turns a direction of the world into the part's frame.
    Vec2 into(const Vec2& way) const {
        return {turn.cosine * way.x() + turn.sine * way.y(),
                turn.cosine * way.y() - turn.sine * way.x()};
    }
    double foot() const {  // height of its lowest corner
        return place.y() - std::fabs(turn.sine) * half.x() - std::fabs(turn.cosine) * half.y();
    }
};

PosedPart posed(const BodyPlan& plan, const Character& character, std::size_t part) {
    const PlannedPart& planned = plan.parts[part];
    const Pose& pose = character.posture.empty() ? planned.rest_pose : character.posture[part];
    const double angle = planar_angle(pose);
    return {planned.half_extents.head<2>(), pose.position.head<2>(), sine_cosine(angle)};
}

// What parts are compared by when the head is chosen.
struct WholeBody {
    double size = 0.0;  // m
    Vec2 middle = Vec2::Zero();
    double foot = 0.0;  // m; height of its lowest corner
};

WholeBody whole_body(const Phenotype& phenotype, const Character& character) {
    WholeBody body{body_size(phenotype), Vec2::Zero(), 1e9};
    double area = 0.0;
    for (std::size_t i = 0; i < phenotype.plan.parts.size(); ++i) {
        const PosedPart part = posed(phenotype.plan, character, i);
        const double share = part.half.x() * part.half.y();
        body.middle += share * part.place;
        area += share;
        body.foot = std::min(body.foot, part.foot());
    }
    body.middle /= area;
    return body;
}

// How well a part would serve as a head, in m.
double headship(const PosedPart& part, const WholeBody& body, const Character& character) {
    const Vec2 from_middle = part.place - body.middle;
    const Vec2 ahead = part.into(character.way);
    double merit = from_middle.dot(character.way) + std::fabs(ahead.x()) * part.half.x() +
                   std::fabs(ahead.y()) * part.half.y();
    // Parts too thin for eyes that can be seen.
    const bool thin = part.half.minCoeff() < 0.036 * body.size;
    if (!character.walks) {
        return merit - (thin ? 1.5 * body.size : 0.0) -
               0.9 * std::fabs(from_middle.dot(across(character.way)));
    }
    if (thin) merit -= 0.6 * body.size;
    // Feet have no eyes if other parts ahead can.
    if (part.foot() < body.foot + 0.06 * body.size) merit -= 0.35 * body.size;
    return merit + 0.5 * from_middle.y();
}

// The corner that is ahead and high, so far inside that an eye of this radius sits on the edge.
Vec2 upper_front(const Vec2& half, const Vec2& ahead, const Vec2& up, double radius) {
    const Vec2 reach(std::max(0.0, half.x() - 0.85 * radius),
                     std::max(0.0, half.y() - 0.75 * radius));
    Vec2 best = reach;
    double most = -1e9;
    for (const double x : {-reach.x(), reach.x()}) {
        for (const double y : {-reach.y(), reach.y()}) {
            const double merit = Vec2(x, y).dot(ahead + 0.75 * up);
            if (merit > most) best = {x, y};
            most = std::max(most, merit);
        }
    }
    return best;
}

}  // namespace

double chance(std::uint64_t number, std::uint64_t purpose) {
    std::uint64_t bits = number + 0x9E3779B97F4A7C15U * (purpose + 1);
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    bits ^= bits >> 31U;
    return static_cast<double>(bits >> 40U) / 16777216.0;
}

double body_size(const Phenotype& phenotype) {
    double area = 0.0;
    for (const PlannedPart& part : phenotype.plan.parts)
        area += 4.0 * part.half_extents.x() * part.half_extents.y();
    return std::sqrt(area);
}

Eyes eyes_of(const Phenotype& phenotype, const Character& character) {
    const BodyPlan& plan = phenotype.plan;
    const WholeBody body = whole_body(phenotype, character);
    Eyes eyes;
    double most = -1e9;
    for (std::size_t i = 0; i < plan.parts.size(); ++i) {
        const double merit = headship(posed(plan, character, i), body, character);
        // Parts of mirrored twins differ by rounding only; the first is the head.
        if (merit > most + 1e-9) eyes.part = i;
        most = std::max(most, merit);
    }
    const PosedPart head = posed(plan, character, eyes.part);
    const Vec2& half = head.half;
    const double narrow = half.minCoeff();
    // Eyes may bulge out of a thin head, but not much.
    const double radius = std::min(std::clamp(0.52 * narrow, 0.06 * body.size, 0.13 * body.size),
                                   std::max(0.95 * narrow, 0.045 * body.size));
    const Vec2 ahead = head.into(character.way);
    if (character.walks) {
        const Vec2 front = upper_front(half, ahead, head.into({0.0, 1.0}), radius);
        const Vec2 behind = front - 1.5 * radius * ahead;
        eyes.places = {front, behind.cwiseMax(-half).cwiseMin(half)};
        eyes.radii = {radius, 0.86 * radius};
    } else {
        // The face that looks ahead most.
        const bool lengthwise = std::fabs(ahead.x()) >= std::fabs(ahead.y());
        const double sign = (lengthwise ? ahead.x() : ahead.y()) < 0.0 ? -1.0 : 1.0;
        const Vec2 facing = lengthwise ? Vec2(sign, 0.0) : Vec2(0.0, sign);
        const double reach = std::max(0.0, (lengthwise ? half.x() : half.y()) - 0.75 * radius);
        const Vec2 side = 0.98 * radius * across(facing);
        eyes.places = {reach * facing + side, reach * facing - side};
        eyes.radii = {radius, radius};
    }
    return eyes;
}

bool blinks(const Character& character) {
    const double period = std::floor(character.time / kBlinkPeriod);
    const double start =
        chance(character.line, 40 + static_cast<std::uint64_t>(std::max(0.0, period))) *
        (kBlinkPeriod - 2.0 * kBlink);
    const double since = character.time - period * kBlinkPeriod - start - kBlink;
    return since >= 0.0 && since < kBlink;
}

Vec2 way_of(const Vec2& travelled, bool walks) {
    constexpr double kTelling = 0.3;  // m; less says nothing of a swimmer's way
    if (walks) return {travelled.x() < 0.0 ? -1.0 : 1.0, 0.0};
    if (travelled.norm() < kTelling) return {1.0, 0.0};
    return travelled.normalized();
}

void look_along(Character& character, const Vec2& velocity, double size) {
    constexpr double kSwift = 0.3;  // body sizes a second
    // Pupils turn gradually from ahead to the way of a body in motion.
    const double speed = velocity.norm();
    if (speed > 0.0) character.gaze = std::min(1.0, speed / (kSwift * size)) / speed * velocity;
}

void follow_path(Character& character, std::span<const Vec2> path, const Vec2& here, double size) {
    constexpr double kPathRate = 15.0;  // points a second
    constexpr std::size_t kGlance = 5;  // points; a third of a second
    constexpr std::size_t kRest = 45;   // points; 3 s
    if (path.size() >= kGlance) {
        const Vec2 moved = here - path[path.size() - kGlance];
        look_along(character, moved / (static_cast<double>(kGlance) / kPathRate), size);
    }
    if (path.size() < kRest) return;
    character.asleep = std::all_of(path.end() - kRest, path.end(), [&](const Vec2& point) {
        return (point - here).norm() < 0.02 * size;
    });
}

void look_at(Character& character, const Vec2& from, const Vec2& target) {
    const Vec2 away = target - from;
    if (away.norm() > 0.0) character.gaze = away.normalized();
}

SkinPattern pattern_of(std::uint64_t line) {
    return static_cast<SkinPattern>(line % kSkinPatterns);
}

double wave_of(std::uint64_t line) {
    return 0.17 + 0.09 * chance(line, 1);
}

Color skin_color(const BodyPart& part, double hue, std::uint64_t line) {
    constexpr std::array<double, kLightnesses> lightness = {0.67, 0.56, 0.78};
    constexpr double kHueSpread = 0.12;  // turns, of all gene nodes of a creature
    constexpr double kGoldenShare = 0.6180339887498949;
    const double turned = 0.5 + kGoldenShare * part.node;
    const double place = turned - std::floor(turned) - 0.5;
    const double depth = 0.015 * std::min(part.depth, 4) - (part.mirror.across < 0 ? 0.03 : 0.0);
    return color_of_hue(hue + kHueSpread * place,
                        lightness[line / kSkinPatterns % kLightnesses] + depth, 0.125);
}

std::uint64_t line_or_hue(std::uint64_t line, double hue) {
    constexpr double kLines = 18.0;
    return line != 0 ? line
                     : static_cast<std::uint64_t>(
                           chance(static_cast<std::uint64_t>(hue * 16777216.0), 2) * kLines);
}

}  // namespace cambrian
