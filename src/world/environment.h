#pragma once

namespace cambrian {

inline constexpr double kEarthGravity = 9.81;  // m/s^2

// The medium and ground a trial takes place in. Plain data, part of every experiment's settings and
// saved with them. Knows nothing of physics engines.
struct Environment {
    double gravity = kEarthGravity;    // m/s^2, 0 and up; size of the pull
    double gravity_direction = -90.0;  // degrees from +x, counter-clockwise; -90 is down
    bool has_ground = true;            // the half-space y <= 0
    double friction = 0.8;             // Coulomb coefficient, 0 and up; ground and self-contact
    double elasticity = 0.2;           // share of normal speed kept in a bounce, 0 to 1
    double viscosity_linear =
        0.0;  // N s/m^3 in 3D, N s/m^2 a face length here; drag per normal speed
    double viscosity_quadratic = 0.0;  // kg/m^2 a face length; drag per normal speed squared
    double density = 1.0;              // kg/m^2 of body parts; mass = density * area

    friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace cambrian
