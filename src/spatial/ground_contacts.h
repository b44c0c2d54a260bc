#pragma once

// Which corners of boxes are at the ground, y = 0.

#include "spatial/contacts.h"

namespace cambrian::spatial {

// The numbers of contacts with the ground, part * kCorners + corner, are below this.
inline constexpr int kGroundContacts = kCorners * kMostParts;

// Adds the corners nearer than kContactMargin, in the order of their numbers.
void add_ground_contacts(const Model& model, const Motion& motion, const Kinematics& kinematics,
                         ContactSet& contacts);

// Returns the height of the body's lowest corner, m.
double lowest_corner(const Model& model, const Motion& motion, const Kinematics& kinematics);

}  // namespace cambrian::spatial
