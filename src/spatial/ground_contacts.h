#pragma once

// Which corners of boxes are at the ground, y = 0.

#include "dynamics/contact_policy.h"
#include "spatial/motion.h"

#include <algorithm>

namespace cambrian::spatial {

inline constexpr int kCorners = 8;
inline constexpr int kMostContacts = 4 * kMostParts;

// Four of every part have room, which is one face, and at least those of one part.
inline int most_contacts(const Model& model) {
    return std::max(kCorners, 4 * model.part_count);
}

struct Contact {
    int id = 0;  // part * kCorners + corner
    int body = 0;
    Vec3 point = Vec3::Zero();     // m, of the body, from its centre of mass, in its axes
    double gap = 0.0;              // m; negative is penetration
    Vec3 velocity = Vec3::Zero();  // m/s

    int part() const { return id / kCorners; }
    double closing_speed() const { return -velocity.y(); }
};

struct ContactSet {
    int count = 0;
    int most = kMostContacts;
    Contact items[kMostContacts];

    // Keeps the nearest contacts in the order in which they came.
    void add(const Contact& contact);
    double depth() const;  // m, of the deepest
};

// Finds the corners nearer than kContactMargin, in the order of their numbers.
void detect_ground(const Model& model, const Motion& motion, const Kinematics& kinematics,
                   ContactSet& contacts);

// Returns the corner's place from the centre of mass of all, m.
inline Vec3 place_of(const Kinematics& k, const Contact& contact) {
    return k.place[contact.body] + k.turn[contact.body] * contact.point;
}

// Returns the height of the body's lowest corner, m.
double lowest_corner(const Model& model, const Motion& motion, const Kinematics& kinematics);

}  // namespace cambrian::spatial
