#include "pictures/race.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLaneShare = 0.62;    // of a lane's height that its creature fills at first
constexpr double kSpanShare = 0.8;     // of a lane's width between the first and the last
constexpr double kLeastTravel = 0.05;  // m; less has no direction
constexpr double kRaceHeader = 46.0;   // pixels, in a picture of the usual size
constexpr double kLaneGap = 3.0;
constexpr double kWordsShade = 0.5;  // of the strip behind words that stays
constexpr double kLook = 0.1;        // s between two looks at how far apart runners are

// A change of place that leaves a world as it is.
struct Turning {
    Rotation turn = Rotation::Identity();
    bool mirrored = false;  // left and right, in the plane
    Vec3 start = Vec3::Zero();

    Vec3 direction(const Vec3& of) const {
        const Vec3 turned = turn * of;
        return mirrored ? Vec3(-turned.x(), turned.y(), turned.z()) : turned;
    }
    Vec3 place(const Vec3& at) const { return direction(at - start); }
    Vec2 place(const Vec2& at) const { return place(Vec3(at.x(), at.y(), start.z())).head<2>(); }
    Pose pose(const Pose& at) const {
        if (!mirrored) return {place(at.position), turn * at.orientation};
        const Vec3 there = place(at.position);
        return planar_pose(there.x(), there.y(), -planar_angle(at));
    }
};

// Where the ground or the direction of gravity matters, heights stay as they are.
Turning turning_of(const Subject& subject) {
    if (subject.motion().wall || !subject.environment().terrain.is_flat()) return {};
    const MotionFrame& first = subject.motion().frames.front();
    const Vec3 start = first.center_of_mass;
    Vec3 travelled = subject.motion().frames.back().center_of_mass - start;
    const Environment& world = subject.environment();
    const bool upright = world.has_ground || world.gravity != 0.0;
    Turning turning;
    turning.start = start;
    if (upright) {
        turning.start.y() = 0.0;
        travelled.y() = 0.0;
    }
    const bool free = !first.light && !first.bout && travelled.norm() > kLeastTravel;
    if (!free || (upright && world.gravity_direction != -90.0)) return turning;
    if (world.dimensions == 2 && upright) {
        turning.mirrored = travelled.x() < 0.0;
    } else {
        turning.turn = Rotation::FromTwoVectors(travelled, Vec3::UnitX());
    }
    return turning;
}

void turn_motion(RecordedMotion& motion, const Turning& turning) {
    for (MotionFrame& frame : motion.frames) {
        for (Pose& pose : frame.poses)
            pose = turning.pose(pose);
        frame.center_of_mass = turning.place(frame.center_of_mass);
        if (frame.light) frame.light = turning.place(*frame.light);
        if (!frame.bout) continue;
        frame.bout->cube = turning.pose(frame.bout->cube);
        for (Pose& pose : frame.bout->opponent)
            pose = turning.pose(pose);
    }
    for (Vec2& center : motion.centers)
        center = turning.place(center);
    for (Scuff& scuff : motion.scuffs) {
        scuff.place = turning.place(scuff.place);
        scuff.velocity =
            turning.direction(Vec3(scuff.velocity.x(), scuff.velocity.y(), 0.0)).head<2>();
    }
}

// The first and the last of the runners at a time, in m.
struct RunnerSpan {
    double low = 0.0;
    double high = 0.0;

    double width() const { return high - low; }
    double middle() const { return 0.5 * (low + high); }
};

RunnerSpan span_at(const std::vector<Subject>& runners, double time) {
    RunnerSpan span{1e9, -1e9};
    for (const Subject& runner : runners) {
        const double along = runner.motion().at(time).center_of_mass.x();
        span.low = std::min(span.low, along);
        span.high = std::max(span.high, along);
    }
    return span;
}

// The widest span up to each look.
std::vector<double> widest_spans(const std::vector<Subject>& runners, double length) {
    std::vector<double> spans;
    for (double look = 0.0; look <= length + 2.0 * kLook; look += kLook) {
        const double width = span_at(runners, look).width();
        spans.push_back(spans.empty() ? width : std::max(spans.back(), width));
    }
    return spans;
}

// Darkens rows of a picture.
void darken_rows(Image& image, double top, double height) {
    const auto row = 3U * static_cast<std::size_t>(image.width);
    const auto first = static_cast<std::size_t>(top) * row;
    const auto last = std::min(static_cast<std::size_t>(top + height) * row, image.rgb.size());
    for (std::size_t i = first; i < last; ++i)
        image.rgb[i] = static_cast<std::uint8_t>(kWordsShade * image.rgb[i]);
}

void add_lane_words(PictureCanvas& canvas, const Area& lane, const std::string& name,
                    double distance, double unit) {
    const double size = std::min(20.0 * unit, 0.2 * lane.height);
    const double base = lane.y + 1.15 * size;
    const double inset = 14.0 * unit;
    const double top = lane.y;
    canvas.add_touch(
        [top, size](Image& image) { darken_rows(image, top, std::round(1.55 * size)); });
    const Ink ink{Typeface::kStrong, size, palette_of(ThemeKind::kDark).text};
    canvas.add_text(lane.x + inset, base, name, ink, Align::kLeft, 0.6 * lane.width);
    canvas.add_text(lane.right() - inset, base, fmt::format("{:.1f} m", distance), ink,
                    Align::kRight);
}

}  // namespace

Race::Race(std::vector<Subject> runners) : runners_(std::move(runners)) {
    for (Subject& runner : runners_) {
        turn_motion(runner.trial.motion, turning_of(runner));
        length_ = std::max(length_, runner.motion().length());
    }
    widest_ = widest_spans(runners_, length_);
}

// The picture grows smoothly: between two looks, the span does.
double Race::scale_at(double time, const Area& lane) const {
    double scale = 1e9;
    for (const Subject& runner : runners_)
        scale = std::min(scale, scale_to_fit(runner.motion(), lane, kLaneShare));
    const double looks = std::clamp(time / kLook, 0.0, static_cast<double>(widest_.size() - 2));
    const auto before = static_cast<std::size_t>(looks);
    const double span = widest_[before] + (widest_[before + 1] - widest_[before]) *
                                              (looks - static_cast<double>(before));
    return std::min(scale, kSpanShare * lane.width / std::max(1e-3, span));
}

double Race::distance(std::size_t runner, double time) const {
    const RecordedMotion& motion = runners_[runner].motion();
    return motion.at(time).center_of_mass.x() - motion.frames.front().center_of_mass.x();
}

void Race::draw(PictureCanvas& canvas, const Palette& palette, double time) const {
    const double unit = layout_unit(canvas);
    canvas.clear(palette.window);
    const double top = std::round(kRaceHeader * unit);
    const double gap = std::round(kLaneGap * unit);
    const auto count = static_cast<double>(runners_.size());
    const double height = std::floor((canvas.height() - top - gap * (count - 1.0)) / count);
    const Area first = {0.0, top, static_cast<double>(canvas.width()), height};
    const RunnerSpan span = span_at(runners_, time);
    const MomentStyle style{.palette = palette,
                            .pixels_per_metre = scale_at(time, first),
                            .label_size = 13.0 * unit,
                            .trail = 0,
                            .world = &world_of(runners_.front()),
                            .along = span.middle()};
    for (std::size_t i = 0; i < runners_.size(); ++i) {
        Area lane = first;
        lane.y += static_cast<double>(i) * (height + gap);
        const Subject& runner = runners_[i];
        add_moment(canvas, lane, runner, moment_of(runner.motion(), time), style);
        add_lane_words(canvas, lane, runner.name, distance(i, time), unit);
    }
    const Ink title{Typeface::kStrong, 24.0 * unit, palette.text};
    const double left = 14.0 * unit;
    canvas.add_text(left, 0.72 * top, "Race: " + runners_.front().goal, title);
    canvas.add_text(canvas.width() - left, 0.72 * top, fmt::format("{:.1f} s", time), title,
                    Align::kRight);
}

Status write_race(PictureCanvas& canvas, const Race& race, const ClipOrder& order,
                  const TrialWatch& watch) {
    const auto draw = [&](std::uint64_t frame) {
        race.draw(canvas, order.palette, clip_time(order.timing, frame));
    };
    return write_pictures(canvas, order, clip_frames(order.timing), draw, draw, watch);
}

}  // namespace cambrian
