#pragma once

// What every physics refuses, in the plane and in space.

#include "core/result.h"
#include "world/body_plan.h"
#include "world/environment.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <span>
#include <string>

namespace cambrian {

// Fails if a number is not finite, or if no step could be made.
Status check_surroundings(const Environment& environment, const SceneSettings& settings);

inline constexpr double kMinHalfExtent = 0.01;  // m
inline constexpr double kMinMassShare = 1e-4;   // of a body, of the total mass
// Child lengths per second, for each rad/s of a motor's limit.
inline constexpr double kRateLengthShare = 0.25;

Error part_error(std::size_t part, const std::string& problem);

// Fails if there are no parts or too many, or where check(plan, part) does.
Status check_plan(const BodyPlan& plan, double density, std::size_t most_parts,
                  Status (*check)(const BodyPlan& plan, std::size_t part));

// Says which one was meant, or which there are.
Error unknown_integrator(const std::string& id, std::span<const std::string> known);

// Whether a motion has so many coordinates, speeds and targets, all of them finite.
bool has_numbers(const SceneMotion& motion, std::size_t positions, std::size_t speeds,
                 std::size_t targets);

}  // namespace cambrian
