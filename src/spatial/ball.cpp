#include "spatial/ball.h"

#include <algorithm>

namespace cambrian::spatial {
namespace {

constexpr double kLeastSwing = 1e-6;   // rad; a lesser one has no direction
constexpr double kLeastCurved = 0.05;  // rad; narrower ways round the axis count as this wide

double hypotenuse(double a, double b) {
    return std::sqrt(a * a + b * b);
}

}  // namespace

BallAngles ball_angles(const Rotation& q) {
    const double half_cosine = hypotenuse(q.w(), q.x());
    const double half_sine = hypotenuse(q.y(), q.z());
    // Without the twist, the vector of the swing's quaternion.
    const double w = half_cosine > 0.0 ? q.w() / half_cosine : 1.0;
    const double x = half_cosine > 0.0 ? q.x() / half_cosine : 0.0;
    const double share =
        half_sine > 0.0 ? 2.0 * arc_tangent2(half_sine, half_cosine) / half_sine : 2.0;
    return {share * (q.y() * x + q.z() * w), share * (q.y() * w - q.z() * x),
            2.0 * arc_tangent2(w < 0.0 ? -x : x, std::fabs(w))};
}

Rotation ball_attitude(const BallAngles& angles) {
    const SineCosine half = sine_cosine(0.5 * angles.twist);
    return product(rotation_by({0.0, angles.bend_y, angles.bend_z}),
                   {half.cosine, half.sine, 0.0, 0.0});
}

// With the turned x axis b and u = x cross b, the bends are the components of f u with f = swing /
// sin(swing).
BallAngles ball_rates(const Rotation& q, const Vec3& spin) {
    const Vec3 b = turn_of(q).axis[0];
    const Vec3 b_rate = cross(spin, b);
    const double sine = hypotenuse(b.y(), b.z());
    const double cosine = b.x();
    if (sine < kLeastSwing)
        return cosine > 0.0 ? BallAngles{spin.z(), spin.y(), spin.x()} : BallAngles{};
    const double swing = arc_tangent2(sine, cosine);
    const double factor = swing / sine;
    const double swing_rate = (b.y() * spin.z() - b.z() * spin.y()) / sine;
    const double factor_rate = (1.0 - factor * cosine) / sine * swing_rate;
    return {factor_rate * b.y() + factor * b_rate.y(), -factor_rate * b.z() - factor * b_rate.z(),
            (spin.x() + dot(b, spin)) / (1.0 + cosine)};
}

Vec3 turn_between(const Rotation& from, const Rotation& to) {
    const Rotation turn = product({from.w(), -from.x(), -from.y(), -from.z()}, to);
    const Vec3 axis(turn.x(), turn.y(), turn.z());
    const double half_sine = std::sqrt(dot(axis, axis));
    const double share =
        half_sine > 0.0 ? 2.0 * arc_tangent2(half_sine, turn.w()) / half_sine : 2.0;
    return share * axis;
}

// The swing's rate is n.s with the unit vector n along a cross b, the twist's (a + b).s / (1 +
// cos(swing)); biases are the derivatives of these factors.
BallDirections ball_directions(const Turn& frame, const Turn& body, const Vec3& spin) {
    const Vec3& a = frame.axis[0];
    const Vec3& b = body.axis[0];
    BallDirections directions;
    const double cosine = dot(a, b);
    const double share = 1.0 / std::max(1.0 + cosine, kLeastSwing);
    directions.twist = share * (a + b);
    const Vec3 across = cross(a, b);
    const double sine = std::sqrt(dot(across, across));
    directions.swing = sine < kLeastSwing ? frame.axis[2] : Vec3(across / sine);
    const double swing_rate = dot(directions.swing, spin);
    directions.swing_bias =
        (cosine * (dot(spin, spin) - swing_rate * swing_rate) - dot(spin, a) * dot(spin, b)) /
        std::max(sine, kLeastCurved);
    directions.twist_bias = dot(directions.twist, spin) * share * sine * swing_rate;
    return directions;
}

}  // namespace cambrian::spatial
