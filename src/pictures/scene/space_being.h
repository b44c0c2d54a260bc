#pragma once

// Converts a creature in space to solids.

#include "pictures/scene/scene_builder.h"
#include "render/space_frame.h"

#include <span>
#include <vector>

namespace cambrian {

// What is known of a creature in space besides its look, which tells nothing of directions there.
struct SpaceManner {
    Vec3 way = Vec3::UnitX();  // in which it travels from its posture
    Vec3 gaze = Vec3::Zero();  // as Character::gaze
    float alpha = 1.0F;
};

// Adds a creature: alive in its pattern and with eyes, or as the boxes that physics moves.
void add_being(SpaceFrame& frame, const CreatureLook& look, const SpaceManner& manner);

// Whether a body has a depth.
inline bool lives_in_space(const Phenotype& phenotype) {
    return phenotype.parts.front().thickness > 0.0;
}

// Returns the direction of travel of a creature that moved by this much in its trial, in m.
Vec3 space_way_of(const Vec3& travelled);

// Sets the gaze and the sleep of a creature as follow_path() does. `path` has its last places,
// fifteen a second, oldest first.
void follow_path(Character& character, SpaceManner& manner, std::span<const Vec3> path,
                 const Vec3& here, double size);

// The part that a ray from the camera meets first, and where.
struct PartHit {
    int part = -1;              // -1 for none
    Vec3 place = Vec3::Zero();  // m
};
PartHit part_at(const Phenotype& phenotype, std::span<const Pose> poses, const SpaceCamera& camera,
                const Vec2& pixel);

// Adds the corners of all parts.
void add_corners(std::vector<Vec3>& corners, const Phenotype& phenotype,
                 std::span<const Pose> poses);

}  // namespace cambrian
