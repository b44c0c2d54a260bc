#pragma once

// Points at which parts touch the ground or one another.

#include "dynamics/contact_policy.h"
#include "spatial/motion.h"

#include <algorithm>

namespace cambrian::spatial {

inline constexpr int kCorners = 8;
inline constexpr int kMostContacts = 6 * kMostParts;

// Four of every part have room on the ground, which is one face, and at least those of one part;
// two more of every part, where parts touch one another.
inline int most_contacts(const Model& model) {
    return std::max(kCorners, 4 * model.part_count) +
           std::min(4 * model.pair_count, 2 * model.part_count);
}

// The normal of the ground and two tangents.
inline const Turn kGroundSurface{{Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()}};

struct Contact {
    int id = 0;  // constant for the same features from step to step; smaller ones are on the ground
    int body = 0;
    int part = 0;
    Vec3 point = Vec3::Zero();  // m, of the body, from its centre of mass, in its axes
    double gap = 0.0;           // m; negative is penetration
    Vec3 rate = Vec3::Zero();   // m/s, along the axes of the surface; opening is positive
    // What it touches: the ground, or the surface of another part.
    int other_body = -1;
    int other_part = -1;
    // The normal, towards the body, and two tangents, in the axes of the other body.
    Turn surface = kGroundSurface;

    bool is_on_ground() const { return other_body < 0; }
    double closing_speed() const { return -rate.x(); }
};

struct ContactSet {
    int count = 0;
    int most = kMostContacts;
    Contact items[kMostContacts];

    // Keeps the nearest contacts in the order in which they came.
    void add(const Contact& contact);
    double depth() const;  // m, of the deepest
};

// Returns the contact's place from the centre of mass of all, m.
inline Vec3 place_of(const Kinematics& k, const Contact& contact) {
    return k.place[contact.body] + k.turn[contact.body] * contact.point;
}

// Returns the axes of the surface in the world.
inline Turn surface_of(const Kinematics& k, const Contact& contact) {
    return contact.is_on_ground() ? contact.surface : k.turn[contact.other_body] * contact.surface;
}

// Whether both are of one corner, or of one pair of parts.
inline bool are_of_one_pair(const Contact& a, const Contact& b) {
    if (a.is_on_ground() || b.is_on_ground()) return a.id == b.id;
    return std::minmax(a.part, a.other_part) == std::minmax(b.part, b.other_part);
}

// Finds all that are nearer than kContactMargin, in the order of their numbers.
void detect_contacts(const Model& model, bool has_ground, const Motion& motion,
                     const Kinematics& kinematics, ContactSet& contacts);

}  // namespace cambrian::spatial
