#pragma once

// Contact points of boxes with the ground or with each other (planar/README.md 8).

#include "core/assert.h"
#include "dynamics/contact_policy.h"
#include "planar/model/planar_model.h"
#include "world/fixed_box.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cambrian {

inline constexpr int kGroundContactIds = 4 * kMaxParts;
inline constexpr int kIdsPerPair = 8;
inline constexpr int kMostPairs = kMaxParts * (kMaxParts - 1) / 2;
inline constexpr int kFixedContactIds = kGroundContactIds + kIdsPerPair * kMostPairs;
inline constexpr int kTerrainContactIds =
    kFixedContactIds + kIdsPerPair * kMaxParts * kMostFixedBoxes;
inline constexpr int kIdsPerFeature = 8 * kMaxParts;  // of the terrain, for one body
inline constexpr int kTerrainFeatures = 1 << 15;      // that have numbers of their own

struct Contact {
    int id = 0;  // constant for the same feature from step to step
    int body_a = 0, body_b = -1;
    int part_a = 0, part_b = -1;            // -1: the ground, terrain or a fixed box
    std::uint8_t face_a = 0, face_b = 0;    // Face that touches
    double point_x = 0.0, point_y = 0.0;    // m, material point in body a's frame
    double normal_x = 0.0, normal_y = 1.0;  // unit, from b to a
    double arm_ax = 0.0, arm_ay = 0.0;      // m, world, from a's centre of mass to the point
    double arm_bx = 0.0, arm_by = 0.0;      // m, world, from b's
    double gap = 0.0;                       // m; negative is penetration
    double closing_speed = 0.0;             // m/s, along the normal, positive when approaching
};

inline bool is_on_ground(const Contact& contact) {
    return contact.id < kGroundContactIds;
}

inline bool is_on_terrain(const Contact& contact) {
    return contact.id >= kTerrainContactIds;
}

// Number of a body and a feature of the terrain, or of a pair of boxes.
inline int pair_number(int id) {
    if (id >= kTerrainContactIds) return (id - kTerrainContactIds) / kIdsPerFeature;
    return kMaxBodies * kTerrainFeatures + (id - kGroundContactIds) / kIdsPerPair;
}

// Number of the group that shares one friction row: all contacts of one body with the ground or
// with one feature of the terrain, or both of a pair of boxes.
inline int friction_group(const Contact& contact) {
    if (is_on_ground(contact)) return contact.body_a;
    return kMaxBodies + pair_number(contact.id);
}

// Returns whether two contacts belong to the same pair: two boxes, or a corner and the ground.
inline bool same_pair(const Contact& first, const Contact& second) {
    if (is_on_ground(first) || is_on_ground(second) || is_on_terrain(first))
        return first.id == second.id;
    return friction_group(first) == friction_group(second);
}

// The order in which contacts are detected: those with the ground by part, or with the terrain by
// body and feature, then pairs of boxes, those with a fixed one last.
inline int detection_rank(int id) {
    if (id < kGroundContactIds) return id / 4;
    return kMaxParts + pair_number(id);
}

struct ContactSet {
    int count = 0;
    int most = kContactsOfOne;  // at most kMaxContacts
    Contact items[kMaxContacts];

    // Returns the place for a contact with this gap, at the end. A full set drops its farthest
    // contact; the place is null if none is farther.
    Contact* make_room(double gap) { return count < most ? &items[count++] : drop_farthest(gap); }
    void add(const Contact& contact) {
        if (Contact* place = make_room(contact.gap)) *place = contact;
    }
    // Returns how deep the deepest contact is, m.
    double depth() const {
        double depth = 0.0;
        for (int c = 0; c < count; ++c)
            depth = std::max(depth, -items[c].gap);
        return depth;
    }

private:
    Contact* drop_farthest(double gap) {
        CAMBRIAN_TICK_ASSERT(count == most, "there is no room");
        int farthest = 0;
        for (int i = 1; i < count; ++i) {
            if (items[i].gap > items[farthest].gap) farthest = i;
        }
        if (gap >= items[farthest].gap) return nullptr;
        std::copy(items + farthest + 1, items + count, items + farthest);
        return &items[count - 1];
    }
};

// Returns the face of a box whose normal is nearest to a direction in the box's frame.
inline Face face_toward(double x, double y) {
    if (std::fabs(x) >= std::fabs(y)) return x > 0.0 ? Face::kDistal : Face::kProximal;
    return y > 0.0 ? Face::kLeft : Face::kRight;
}

}  // namespace cambrian
