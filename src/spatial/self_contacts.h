#pragma once

// Contacts between the parts of one creature.

#include "spatial/contacts.h"

namespace cambrian::spatial {

// Lists the pairs of parts that may touch, or none. Those of one body, of bodies that share a joint
// and those nearer than 1 cm at rest never do (planar/README.md 2).
void let_parts_touch(Model& model, bool touch);

// Adds all contacts nearer than kContactMargin, by pair and then by their features.
void add_self_contacts(const Model& model, const Kinematics& kinematics, ContactSet& contacts);

}  // namespace cambrian::spatial
