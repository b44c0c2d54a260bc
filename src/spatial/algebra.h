#pragma once

// Matrices, attitudes and spatial vectors of the physics in space. Every sum is written out, so
// that its order, and with it every bit, is the same with every compiler.

#include "math/elementary.h"
#include "math/types.h"

#include <cmath>

namespace cambrian::spatial {

inline double dot(const Vec3& a, const Vec3& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
            a.x() * b.y() - a.y() * b.x()};
}

// A rotation by its columns: the turned axes.
struct Turn {
    Vec3 axis[3] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

    Vec3 operator*(const Vec3& v) const {
        return axis[0] * v.x() + axis[1] * v.y() + axis[2] * v.z();
    }
    Turn operator*(const Turn& other) const {
        return {{*this * other.axis[0], *this * other.axis[1], *this * other.axis[2]}};
    }
    // Returns the components of a vector along the turned axes.
    Vec3 back(const Vec3& v) const { return {dot(axis[0], v), dot(axis[1], v), dot(axis[2], v)}; }
    Turn back(const Turn& other) const {
        return {{back(other.axis[0]), back(other.axis[1]), back(other.axis[2])}};
    }
    // Turns this frame about its own axis of that number.
    void turn_about(int number, const SineCosine& angle) {
        Vec3& first = axis[(number + 1) % 3];
        Vec3& second = axis[(number + 2) % 3];
        const Vec3 turned = angle.cosine * first + angle.sine * second;
        second = angle.cosine * second - angle.sine * first;
        first = turned;
    }
};

inline Rotation product(const Rotation& a, const Rotation& b) {
    return {a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
            a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
            a.w() * b.y() - a.x() * b.z() + a.y() * b.w() + a.z() * b.x(),
            a.w() * b.z() + a.x() * b.y() - a.y() * b.x() + a.z() * b.w()};
}

// Returns the unit quaternion of the same attitude with w >= 0.
inline Rotation normalized(const Rotation& a) {
    const double size = std::sqrt(a.w() * a.w() + a.x() * a.x() + a.y() * a.y() + a.z() * a.z());
    const double scale = (a.w() < 0.0 ? -1.0 : 1.0) / size;
    return {scale * a.w(), scale * a.x(), scale * a.y(), scale * a.z()};
}

// Returns the rotation by |turn| (rad) about the direction of the vector.
inline Rotation rotation_by(const Vec3& turn) {
    const double angle = std::sqrt(dot(turn, turn));
    const SineCosine half = sine_cosine(0.5 * angle);
    // sin(t/2)/t near 0; the omitted term is t^4/3840
    const double share = angle < 1e-3 ? 0.5 - angle * angle / 48.0 : half.sine / angle;
    return {half.cosine, share * turn.x(), share * turn.y(), share * turn.z()};
}

inline Turn turn_of(const Rotation& q) {
    const double w = q.w();
    const double x = q.x();
    const double y = q.y();
    const double z = q.z();
    return {{Vec3(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)),
             Vec3(2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)),
             Vec3(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y))}};
}

// Returns the attitude of a frame, by the largest of its components (S. W. Shepperd, J. Guid.
// Control 1, 1978).
Rotation rotation_of(const Turn& turn);

// Returns the rate of the rotation vector `chart` of exp(chart) Q, which turns with the angular
// velocity `spin` of the outer axes. Exact to 1e-8 for |chart| <= 1.
inline Vec3 chart_rate(const Vec3& chart, const Vec3& spin) {
    const double t = dot(chart, chart);
    const double c = 1.0 / 12 + t * (1.0 / 720 + t * (1.0 / 30240 + t * (1.0 / 1209600)));
    const Vec3 once = cross(chart, spin);
    return spin - 0.5 * once + c * cross(chart, once);
}

// A symmetric matrix of 3 x 3.
struct Symmetric {
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;

    Vec3 operator*(const Vec3& v) const {
        return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z()};
    }
    Symmetric& operator+=(const Symmetric& other);
};

// Returns the inertia of a point of this mass at a place, about the origin.
Symmetric point_inertia(double mass, const Vec3& place);
// Returns the matrix with the axes turned: R S R'.
Symmetric turned(const Symmetric& matrix, const Turn& turn);
// Solves S x = b by cofactors; S is positive definite.
Vec3 solved(const Symmetric& matrix, const Vec3& right);

// A motion (angular, then linear at the origin) or a force (moment about the origin, then force).
struct Six {
    Vec3 angular = Vec3::Zero(), linear = Vec3::Zero();

    Six& operator+=(const Six& other) {
        angular += other.angular;
        linear += other.linear;
        return *this;
    }
    friend Six operator*(double factor, const Six& six) {
        return {factor * six.angular, factor * six.linear};
    }
};

inline double dot(const Six& a, const Six& b) {
    return dot(a.angular, b.angular) + dot(a.linear, b.linear);
}
// Returns the rate of a motion vector that moves with the first motion.
inline Six cross_motion(const Six& by, const Six& motion) {
    return {cross(by.angular, motion.angular),
            cross(by.linear, motion.angular) + cross(by.angular, motion.linear)};
}
// Returns the rate of a force vector that moves with the first motion.
inline Six cross_force(const Six& by, const Six& force) {
    return {cross(by.angular, force.angular) + cross(by.linear, force.linear),
            cross(by.angular, force.linear)};
}

}  // namespace cambrian::spatial
