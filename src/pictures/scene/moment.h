#pragma once

// Draws one instant of a creature's trial in the same way as the viewport.

#include "pictures/canvas/picture_canvas.h"
#include "pictures/motion/subject.h"
#include "pictures/scene/character.h"
#include "pictures/scene/worlds.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace cambrian {

struct MomentStyle {
    const Palette& palette;
    double pixels_per_metre = 100.0;
    double label_size = 13.0;  // pixels; size of the labels on the ground
    std::size_t trail = 60;    // points of the trail
    LookMode look = LookMode::kLife;
    const DrawnWorld* world = nullptr;  // its scenery; null: none, on the palette's sky
    // Place along x, in m, at which the camera looks from the side; by default it follows the
    // creature.
    std::optional<double> along = {};
};

// Returns what a motion tells of the creature at a time, but not its line.
Character character_of(const RecordedMotion& motion, bool walks, double time);

// Returns the scale, in pixels per metre, at which the creature always fits in `share` of the area.
double scale_to_fit(const RecordedMotion& motion, const Area& area, double share);

// Returns `count` evenly spaced times from start to end; a single one is in the middle.
std::vector<double> even_times(const RecordedMotion& motion, int count);

// Returns the time, within the middle half of the motion, at which the creature is most extended.
double telling_time(const RecordedMotion& motion);

// The subject at one time. The camera follows the creature, which is in the middle.
struct Moment {
    double time = 0.0;  // s
    MotionFrame frame;
};
Moment moment_of(const RecordedMotion& motion, double time);
// Returns the subject's world at noon, as pictures show it.
const DrawnWorld& world_of(const Subject& subject);
void add_moment(PictureCanvas& canvas, const Area& area, const Subject& subject,
                const Moment& moment, const MomentStyle& style);

// Returns facts about the body in one line: "4 parts · 3 joints · 7 neurons".
std::string facts_line(const Subject& subject);

}  // namespace cambrian
