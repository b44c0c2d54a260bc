#pragma once

// Contacts of boxes with boxes that never move (dynamics/README.md 8).

#include "dynamics/contact/contact.h"
#include "dynamics/model/part_places.h"
#include "world/fixed_box.h"

#include <span>

namespace cambrian {

// Adds all contacts nearer than kContactMargin, at most two for each pair, by part and then by
// fixed box. Only the first kMostFixedBoxes count.
void detect_fixed_contacts(const PlanarModel& model, const Kinematics& kinematics,
                           const PartPlaces& places, std::span<const FixedBox> fixed,
                           ContactSet& contacts);

}  // namespace cambrian
