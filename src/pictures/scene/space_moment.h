#pragma once

// Draws one instant of the trial of a creature in space.

#include "pictures/scene/moment.h"
#include "pictures/scene/space_world.h"

namespace cambrian {

// An instant of a recorded motion, and how it is seen.
struct SpaceInstant {
    const RecordedMotion& motion;
    const MotionFrame& shown;  // of the motion at `time`
    double time = 0.0;         // s
    const Environment& environment;
    const Individual& creature;
    SpaceLook surroundings = {};
    LookMode look = LookMode::kLife;
    Viewport size;
    double pixels_per_metre = 100.0;
    std::size_t trail = 60;  // points of the trail
    Color trail_color = {};
    double trail_dot = 2.4;  // pixels
    int samples = 1;
    std::optional<double> along = {};  // m; see MomentStyle
};
// Returns the frame of a camera that follows the creature from the side and above.
SpaceFrame space_frame(const SpaceInstant& instant);

// Does what add_moment() does, for subjects in space.
void add_space_moment(PictureCanvas& canvas, const Area& area, const Subject& subject,
                      const Moment& moment, const MomentStyle& style);

// Returns the greatest diameter about its centre of mass that the body has at any time, m.
double widest_body(const RecordedMotion& motion);

}  // namespace cambrian
