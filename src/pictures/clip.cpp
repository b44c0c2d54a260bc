#include "pictures/clip.h"

#include "core/text/pretty_text.h"
#include "evolution/evaluation/trials.h"
#include "pictures/card_picture.h"
#include "pictures/clips/clip_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kClipWidth = 1280.0;  // pixels; width at which the layout has scale 1
constexpr double kClipHeight = 720.0;
constexpr double kLeastUnit = 0.6;       // least scale of text, below which it could not be read
constexpr double kClipBodyShare = 0.42;  // share of the picture that the creature fills
constexpr std::size_t kTrail = 90;       // points of the trail

void draw_frame(PictureCanvas& canvas, const Subject& subject, const ClipOrder& order,
                const Moment& moment) {
    if (order.card) {
        draw_moving_card(canvas, subject, order.palette, moment);
    } else {
        draw_clip_frame(canvas, subject, order.palette, moment);
    }
}

}  // namespace

double layout_unit(const PictureCanvas& canvas) {
    return std::max(kLeastUnit,
                    std::min(canvas.width() / kClipWidth, canvas.height() / kClipHeight));
}

std::uint64_t clip_frames(const ClipTiming& timing) {
    const double frames = timing.seconds / timing.speed * timing.frames_a_second;
    return static_cast<std::uint64_t>(std::max(1.0, std::round(frames)));
}

double clip_time(const ClipTiming& timing, std::uint64_t frame) {
    return static_cast<double>(frame) * timing.speed / timing.frames_a_second;
}

void draw_clip_frame(PictureCanvas& canvas, const Subject& subject, const Palette& palette,
                     const Moment& moment) {
    const double unit = layout_unit(canvas);
    const Area whole = {0, 0, static_cast<double>(canvas.width()),
                        static_cast<double>(canvas.height())};
    const DrawnWorld& world = world_of(subject);
    const Palette& words = palette_over(world);
    MomentStyle style{
        .palette = palette, .label_size = 16.0 * unit, .trail = kTrail, .world = &world};
    style.pixels_per_metre = scale_to_fit(subject.motion(), whole, kClipBodyShare);
    canvas.clear(palette.sky);
    add_moment(canvas, whole, subject, moment, style);
    const Ink title{Typeface::kStrong, 28.0 * unit, words.text};
    const Ink small{Typeface::kRegular, 19.0 * unit, with_alpha(words.text, 0.85F)};
    const double left = 24.0 * unit;
    const double right = canvas.width() - left;
    std::string line = subject.goal;
    if (!subject.fitness.empty()) line += "  ·  " + subject.fitness;
    canvas.add_text(left, 44.0 * unit, subject.name, title, Align::kLeft,
                    right - left - 120.0 * unit);
    canvas.add_text(left, 72.0 * unit, line, small);
    canvas.add_text(right, 44.0 * unit, fmt::format("{:.1f} s", moment.time), title, Align::kRight);
}

ColorCensus census_of(const ClipFormat& format, const std::function<Image(int)>& draw) {
    ColorCensus census;
    for (int i = 0; format.few_colors && i < kCountedPictures; ++i)
        census.add(draw(i));
    return census;
}

Status write_pictures(PictureCanvas& canvas, const ClipOrder& order, std::uint64_t frames,
                      const ClipDrawing& draw, const ClipDrawing& sample, const TrialWatch& watch) {
    const ColorCensus census = census_of(*order.format, [&](int i) {
        sample((frames - 1) * static_cast<std::uint64_t>(i) / (kCountedPictures - 1));
        return canvas.finish();
    });
    auto clip = ClipFile::open(*order.format, {.path = order.path,
                                               .width = canvas.width(),
                                               .height = canvas.height(),
                                               .frames_a_second = order.timing.frames_a_second,
                                               .frames = frames,
                                               .colors = &census,
                                               .dithered = order.dithered,
                                               .creature = order.creature});
    if (!clip) return clip.error();
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        if (watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
        draw(frame);
        if (Status added = (*clip)->add(canvas.finish()); !added) return added;
        watch.note(static_cast<double>(frame + 1) / order.timing.frames_a_second);
    }
    return (*clip)->finish();
}

Status write_clip(PictureCanvas& canvas, const Subject& subject, const Kinds& kinds,
                  const ClipOrder& order, const TrialWatch& watch) {
    auto motion = ReplayedMotion::start(subject.motion().phenotype, kinds, subject.world);
    if (!motion) return motion.error();
    const std::uint64_t frames = clip_frames(order.timing);
    const auto draw = [&](std::uint64_t frame) {
        const double time = clip_time(order.timing, frame);
        draw_frame(canvas, subject, order, {time, motion->at(time)});
        watch.note(time);
    };
    const auto sample = [&](std::uint64_t frame) {
        const double time = clip_time(order.timing, frame);
        draw_frame(canvas, subject, order, moment_of(subject.motion(), time));
    };
    return write_pictures(canvas, order, frames, draw, sample, {.stop = watch.stop});
}

}  // namespace cambrian
