#pragma once

// Corners of boxes near the ground, the half-plane y <= 0.

#include "dynamics/contact.h"
#include "dynamics/kinematics.h"

namespace cambrian {

// Adds every corner nearer to the ground than kContactMargin.
void collect_ground_contacts(const PlanarModel& model, const Kinematics& kinematics,
                             ContactSet& contacts);

// Of the four faces of a box, the one that looks most along a direction given in the box's frame.
Face face_toward(double x, double y);

}  // namespace cambrian
