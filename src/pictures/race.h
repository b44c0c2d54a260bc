#pragma once

// Races: creatures in the same world, each in a lane of one picture, from the same start. A
// creature that travels another way is turned, or shown as in a mirror, if its world looks the same
// then.

#include "pictures/clip.h"

#include <vector>

namespace cambrian {

inline constexpr std::size_t kLeastRunners = 2;
inline constexpr std::size_t kMostRunners = 6;

class Race {
public:
    // All must be of one world, and one at least.
    explicit Race(std::vector<Subject> runners);

    double length() const { return length_; }  // s
    // Returns how far a runner has come to the right at a time (s), in m.
    double distance(std::size_t runner, double time) const;
    // Draws a time (s) of it, with names and distances.
    void draw(PictureCanvas& canvas, const Palette& palette, double time) const;

private:
    double scale_at(double time, const Area& lane) const;

    std::vector<Subject> runners_;
    double length_ = 0.0;
    std::vector<double> widest_;  // m; how far apart they have been up to each look
};

// Notes the seconds of the clip that are written, and gives up when asked to stop; nothing is left
// then.
Status write_race(PictureCanvas& canvas, const Race& race, const ClipOrder& order,
                  const TrialWatch& watch);

}  // namespace cambrian
