#pragma once

// One moment of a creature's trial, drawn as the viewport draws it.

#include "pictures/easel.h"
#include "pictures/subject.h"

#include <cstddef>
#include <vector>

namespace cambrian {

struct MomentStyle {
    const Palette& palette;
    double pixels_per_metre = 100.0;
    double label_size = 13.0;  // pixels; of the ground's metres
    std::size_t trail = 60;    // dots
};

// Pixels a metre so that the creature never fills more than the share of an area of that size.
double scale_to_fit(const RecordedMotion& motion, const Area& area, double share);

// So many times from the start of a motion to its end, evenly; a single one is in the middle.
std::vector<double> even_times(const RecordedMotion& motion, int count);

// A time of the middle half at which the creature reaches out farthest.
double telling_time(const RecordedMotion& motion);

// The subject as it was then. The camera keeps to the creature, which is in the middle.
struct Moment {
    double time = 0.0;  // s
    MotionFrame frame;
};
Moment moment_of(const RecordedMotion& motion, double time);
void add_moment(Easel& easel, const Area& area, const Subject& subject, const Moment& moment,
                const MomentStyle& style);

// What is known of the creature in a line: "4 parts · 3 joints · 7 neurons".
std::string facts_line(const Subject& subject);

}  // namespace cambrian
