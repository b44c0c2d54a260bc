#pragma once

// Overlays of invisible quantities on a creature: forces, torques, limits, sensors.

#include "creature/creature.h"
#include "pictures/scene/scene_builder.h"
#include "world/physics_scene.h"

namespace cambrian {

// A creature as drawn and as simulated.
struct OverlayScene {
    const CreatureLook& look;
    const PhysicsScene& scene;
    const Creature& creature;
    const Surroundings& surroundings;
    const Kinds& kinds;
    const Palette& palette;
    double pixel = 0.01;  // m
};

void add_joint_limits(SceneFrame& frame, const OverlayScene& over);
// Effort over the most each motor has.
void add_joint_torques(SceneFrame& frame, const OverlayScene& over);
// Those the brain hears.
void add_sensor_readings(SceneFrame& frame, const OverlayScene& over);
void add_contact_forces(SceneFrame& frame, const OverlayScene& over);
void add_center_of_mass(SceneFrame& frame, const OverlayScene& over, const Vec2& center);

}  // namespace cambrian
