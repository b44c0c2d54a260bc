#pragma once

namespace cambrian {

inline constexpr double kEarthGravity = 9.81;  // m/s^2

// The medium and ground of a trial. It is plain data, part of the settings of every experiment, and
// independent of the physics engine.
struct Environment {
    double gravity = kEarthGravity;    // m/s^2, at least 0
    double gravity_direction = -90.0;  // degrees from +x, counter-clockwise; -90 is down
    bool has_ground = true;            // the half-space y <= 0
    // Coefficient of Coulomb friction, at least 0, for ground and self-contact.
    double friction = 0.8;
    double elasticity = 0.2;  // coefficient of restitution, in [0, 1]
    double viscosity_linear =
        0.0;  // N s/m^2 per length of a face (N s/m^3 in 3D); drag per normal speed
    double viscosity_quadratic = 0.0;  // kg/m^2 per length of a face; drag per squared normal speed
    double density = 1.0;              // kg/m^2 of body parts; mass = density * area

    friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace cambrian
