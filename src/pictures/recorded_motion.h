#pragma once

// A trial as moments to draw, so that any of them can be drawn in any order.

#include "core/result.h"
#include "pictures/touched_faces.h"
#include "simulator/trial.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace cambrian {

struct MotionFrame {
    std::vector<Pose> poses;  // of the parts
    Vec3 center_of_mass = Vec3::Zero();
    std::vector<FaceSet> touched;  // of each part
};

// The body as it is.
MotionFrame motion_frame(const BodyView& body);

// One creature's trial from the end of settling on, a frame a tick of 1/60 s.
struct RecordedMotion {
    std::shared_ptr<const Phenotype> phenotype;  // null until grown
    std::vector<MotionFrame> frames;
    bool complete = false;

    bool empty() const { return frames.empty(); }
    double length() const;  // s
    // Between two frames; the last one from its end on. Not of an empty one.
    MotionFrame at(double time) const;
    // Where the centre of mass was up to then, oldest first, fifteen a second, at most so many.
    std::vector<Vec2> trail(double time, std::size_t most) const;
};

struct RecordedTrial {
    RecordedMotion motion;  // to where the test phase ended; at least its start
    TrialRecord record;
};

// Runs a whole trial. Fails if physics refuses the body.
Result<RecordedTrial> record_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                                   const TrialWorld& world);

}  // namespace cambrian
