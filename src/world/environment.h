#pragma once

#include "world/terrain_settings.h"

#include <array>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr double kEarthGravity = 9.81;  // m/s^2

// The light's motion (simulator/README.md 5).
inline constexpr std::array<std::string_view, 4> kLightMotionIds = {"still", "jumping", "wandering",
                                                                    "hunting"};

// The medium, ground and light of a trial. It is plain data, part of the settings of every
// experiment, and independent of the physics engine.
struct Environment {
    double gravity = kEarthGravity;    // m/s^2, at least 0
    double gravity_direction = -90.0;  // degrees from +x, counter-clockwise; -90 is down
    bool has_ground = true;            // the half-space y <= 0, or with the shape of the terrain
    TerrainSettings terrain;
    // Coefficient of Coulomb friction, at least 0, for ground and self-contact.
    double friction = 0.8;
    double elasticity = 0.2;  // coefficient of restitution, in [0, 1]
    // Whether parts touch one another in three dimensions. In the plane they always do.
    bool self_contact = false;
    double viscosity_linear =
        0.0;  // N s/m^2 per length of a face (N s/m^3 in 3D); drag per normal speed
    double viscosity_quadratic =
        0.0;  // kg/m^2 per length of a face (kg/m^3 in 3D); drag per squared normal speed
    double density = 1.0;           // kg/m^2 of body parts; mass = density * area (kg/m^3, volume)
    bool has_light = false;         // a lamp, which casts no shadows
    double light_brightness = 1.0;  // intensity at the lamp
    double light_x = 3.0;           // m; place of the lamp, or where it starts
    double light_y = 1.0;           // m
    std::string light_motion = "still";  // one of kLightMotionIds
    double light_range = 5.0;            // m; how far it wanders from its start, each way
    double light_reach = 2.0;            // m; distance at which half the intensity is left
    double light_nearest = 3.0;          // body lengths; least distance of a jump, positive
    double light_farthest = 6.0;         // the same; greatest, not below it
    double light_period = 5.0;           // s between two jumps
    bool deaf = false;                   // nobody hears anything
    bool scentless = false;              // nobody smells anything
    bool has_wall = false;               // a wall on one side, which each trial draws
    double wall_nearest = 3.0;           // m from the body at the start; least distance, positive
    double wall_farthest = 5.0;          // m; greatest, not below it
    bool numb = false;                   // nobody senses walls or ground before it touches them
    int dimensions = 2;                  // or 3, where there is neither ground nor light yet

    friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace cambrian
