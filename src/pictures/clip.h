#pragma once

#include "pictures/canvas/picture_canvas.h"
#include "pictures/clips/clip_format.h"
#include "pictures/motion/subject.h"
#include "pictures/scene/moment.h"
#include "simulator/trial_watch.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

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

// What a clip of a creature's trial shall be; its size is that of the canvas it is drawn on.
struct ClipOrder {
    const ClipFormat* format = nullptr;  // never null
    std::filesystem::path path;
    ClipTiming timing;
    Palette palette;
    bool dithered = false;      // for formats with few colours
    bool card = false;          // a creature card whose portrait moves, rather than the trial alone
    std::string creature = {};  // the creature file inside, if the format can embed one
};

// Draws the picture of a clip with that number.
using ClipDrawing = std::function<void(std::uint64_t frame)>;

// Writes so many pictures. `draw` is called once for each, in order; `sample` draws any picture
// again, or one like it, so that colours can be counted. Notes the seconds of the clip that are
// written, and gives up when asked to stop; nothing is left then.
Status write_pictures(PictureCanvas& canvas, const ClipOrder& order, std::uint64_t frames,
                      const ClipDrawing& draw, const ClipDrawing& sample, const TrialWatch& watch);

// Draws the trial once more and writes it. Notes the time reached, and gives up when asked to stop;
// nothing is left then.
Status write_clip(PictureCanvas& canvas, const Subject& subject, const Kinds& kinds,
                  const ClipOrder& order, const TrialWatch& watch);

// Counts the colours of some pictures of a clip if its format has few colours; `draw` gives the
// picture of a number from 0 to kCountedPictures - 1.
inline constexpr int kCountedPictures = 8;
ColorCensus census_of(const ClipFormat& format, const std::function<Image(int)>& draw);

}  // namespace cambrian
