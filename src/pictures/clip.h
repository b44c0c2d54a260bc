#pragma once

#include "pictures/easel.h"
#include "pictures/moment.h"
#include "pictures/subject.h"

#include <cstdint>

namespace cambrian {

// How a trial is shown as a clip.
struct ClipTiming {
    double frames_a_second = 30.0;
    double speed = 1.0;    // 1 is real time
    double seconds = 0.0;  // of the trial, from its start
};

// At least one: the start.
std::uint64_t clip_frames(const ClipTiming& timing);

// When a frame of it is, s of the trial.
double clip_time(const ClipTiming& timing, std::uint64_t frame);

// One frame of a clip, with the creature's name, its score and the time.
void draw_clip_frame(Easel& easel, const Subject& subject, const Palette& palette,
                     const Moment& moment);

}  // namespace cambrian
