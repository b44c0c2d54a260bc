#pragma once

#include "pictures/canvas/picture_canvas.h"
#include "pictures/motion/subject.h"
#include "pictures/scene/moment.h"

#include <cstdint>

namespace cambrian {

// Frame rate, speed and duration of a clip.
struct ClipTiming {
    double frames_a_second = 30.0;
    double speed = 1.0;    // 1 is real time
    double seconds = 0.0;  // s of the trial, from its start
};

// Returns the scale of text and margins in a frame of the canvas's size.
double layout_unit(const PictureCanvas& canvas);

// Returns the number of frames, at least 1.
std::uint64_t clip_frames(const ClipTiming& timing);

// Returns the time of a frame in the trial, in s.
double clip_time(const ClipTiming& timing, std::uint64_t frame);

// Draws one frame of a clip, with the creature's name, its score and the time.
void draw_clip_frame(PictureCanvas& canvas, const Subject& subject, const Palette& palette,
                     const Moment& moment);

}  // namespace cambrian
