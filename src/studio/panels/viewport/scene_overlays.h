#pragma once

// Overlays that draw invisible quantities on a creature: forces, torques, limits, sensor readings.

#include "creature/creature.h"
#include "pictures/scene/scene_builder.h"
#include "world/physics_scene.h"

namespace cambrian {

inline constexpr double kFullTorqueTurn = 2.2;  // rad; arc for the largest torque of a motor
// Length drawn for a force equal to the creature's weight, in m.
inline constexpr double kForceLength = 1.0 / 3.0;

// The creature as drawn and the scene that simulates it.
struct OverlayScene {
    const CreatureLook& look;
    const PhysicsScene& scene;
    const Creature& creature;
    const Surroundings& surroundings;
    const Kinds& kinds;
    const Palette& palette;
    double pixel = 0.01;  // size of a pixel, in m
};

void add_joint_limits(SceneFrame& frame, const OverlayScene& over);
// Draws each motor's effort as a share of its largest effort.
void add_joint_torques(SceneFrame& frame, const OverlayScene& over);
// Draws the readings of the sensors that the brain uses.
void add_sensor_readings(SceneFrame& frame, const OverlayScene& over);
void add_contact_forces(SceneFrame& frame, const OverlayScene& over);
void add_center_of_mass(SceneFrame& frame, const OverlayScene& over, const Vec2& center);

}  // namespace cambrian
