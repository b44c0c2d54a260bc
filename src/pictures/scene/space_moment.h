#pragma once

// Draws one instant of the trial of a creature in space.

#include "pictures/scene/moment.h"

namespace cambrian {

// Does what add_moment() does, for subjects in space.
void add_space_moment(PictureCanvas& canvas, const Area& area, const Subject& subject,
                      const Moment& moment, const MomentStyle& style);

// Returns the greatest diameter about its centre of mass that the body has at any time, m.
double widest_body(const RecordedMotion& motion);

}  // namespace cambrian
