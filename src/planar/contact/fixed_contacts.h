#pragma once

// Contacts of boxes with boxes that never move (planar/README.md 8).

#include "planar/contact/box_contacts.h"
#include "planar/contact/contact.h"
#include "planar/model/kinematics.h"
#include "world/fixed_box.h"

#include <span>

namespace cambrian {

// Adds all contacts nearer than kContactMargin, at most two for each pair, by part and then by
// fixed box. Only the first kMostFixedBoxes count.
void detect_fixed_contacts(const PlanarModel& model, const Kinematics& kinematics,
                           const PartPlaces& places, std::span<const FixedBox> fixed,
                           ContactSet& contacts);

// Returns into how many equal parts a motion must be divided so that no box which might meet a
// fixed one moves farther than the smaller side of either in one of them. The result is not whole,
// and at least 1.
[[gnu::noinline]] double count_looks_at_fixed(const BoxEnds& ends, const BoxTravels& travels,
                                              const BoxSides& sides,
                                              std::span<const FixedBox> fixed);

// Contacts of the corners of boxes with the ground, the half-plane y <= 0.

// Adds every corner nearer to the ground than kContactMargin.
void detect_ground_contacts(const PlanarModel& model, const Kinematics& kinematics,
                            const PartPlaces& places, ContactSet& contacts);

}  // namespace cambrian
