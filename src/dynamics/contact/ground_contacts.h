#pragma once

// Contacts of the corners of boxes with the ground, the half-plane y <= 0.

#include "dynamics/contact/contact.h"
#include "dynamics/model/part_places.h"

namespace cambrian {

// Adds every corner nearer to the ground than kContactMargin.
void detect_ground_contacts(const PlanarModel& model, const Kinematics& kinematics,
                            const PartPlaces& places, ContactSet& contacts);

}  // namespace cambrian
