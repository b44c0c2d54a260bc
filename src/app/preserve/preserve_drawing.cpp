#include "app/preserve/preserve_drawing.h"

#include "app/preserve/past_world.h"
#include "app/process/messages.h"
#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "core/text/pretty_text.h"
#include "persist/creature/png_file.h"
#include "pictures/clip.h"
#include "pictures/clips/clip_file.h"
#include "pictures/workshop.h"
#include "pictures/world_picture.h"
#include "simulator/simulator_version.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kUsualSeconds = 60.0;  // of a clip

struct Span {
    double from = 0.0;  // s
    double to = 0.0;
};

double seconds_of(const SnapshotEntry& snapshot) {
    return static_cast<double>(snapshot.tick) * kBrainTick;
}

std::uint64_t tick_of(double seconds) {
    return static_cast<std::uint64_t>(std::llround(seconds / kBrainTick));
}

// Returns the times to show; fails if the file does not have them.
Result<Span> span_of(const PreserveDrawing& drawing, const SavedPreserve& saved) {
    const double first = seconds_of(saved.snapshots.front());
    const double last = seconds_of(saved.snapshots.back());
    const auto outside = [&](const char* option, const std::optional<double>& time) {
        return time && (*time < first || *time > last)
                   ? std::optional(Error{fmt::format(
                         "{}: {} {} is outside {} s to {} s, from its first snapshot to its last",
                         drawing.file, option, short_text(*time), short_text(first),
                         short_text(last))})
                   : std::nullopt;
    };
    if (const auto fault = outside("--from", drawing.from)) return *fault;
    if (const auto fault = outside("--to", drawing.to)) return *fault;
    if (drawing.format == nullptr) {
        const double at = drawing.from.value_or(last);
        return Span{at, at};
    }
    const double to = drawing.to.value_or(last);
    const double from = drawing.from.value_or(std::max(first, to - kUsualSeconds));
    if (from < to) return Span{from, to};
    if (drawing.from) {
        return Error{fmt::format("{}: --from {} is not before {} s, where the clip ends",
                                 drawing.file, short_text(from), short_text(to))};
    }
    return Error{fmt::format("{}: nothing moves yet at {} s, where the clip ends", drawing.file,
                             short_text(to))};
}

// Returns the last snapshot up to a time in s.
const SnapshotEntry& snapshot_before(const SavedPreserve& saved, double time) {
    const auto later =
        std::find_if(saved.snapshots.begin() + 1, saved.snapshots.end(),
                     [&](const SnapshotEntry& each) { return each.tick > tick_of(time); });
    return *(later - 1);
}

// Draws a world that is computed again, moment by moment.
class Drawer {
public:
    Drawer(const PreserveDrawing& drawing, PastWorld& world, PictureCanvas& canvas, LongWork& work)
        : drawing_(drawing),
          world_(world),
          canvas_(canvas),
          work_(work),
          pool_(ThreadPool::default_workers()),
          begun_(world.preserve().ticks()) {}

    Status go_to(double seconds) {
        const Result<bool> reached = world_.go_to(tick_of(seconds), pool_, [&](std::uint64_t tick) {
            work_.watch().note(static_cast<double>(tick - begun_) * kBrainTick);
            return !work_.interrupted();
        });
        if (!reached) return reached.error();
        return *reached ? Status() : Error{"interrupted; nothing was written"};
    }

    Image picture() { return picture_of(world_, camera_); }
    // Draws a world apart from those of the clip.
    Image picture_of(const PastWorld& world) {
        PreserveCamera camera;
        return picture_of(world, camera);
    }
    Image picture_of(const PastWorld& world, PreserveCamera& camera) {
        PreservePicture picture;
        camera.take(world.preserve(), picture);
        picture.died = std::make_shared<const std::vector<Life>>(world.died());
        const std::string name = std::filesystem::path(drawing_.file).stem().string();
        draw_world_frame(canvas_, drawing_.palette, picture, capitalized(name));
        return canvas_.finish();
    }

    Status write_picture() {
        const Result<std::string> png = encode_png(picture());
        return png ? write_file(drawing_.out, *png) : Status(png.error());
    }

    Status write_clip(const Span& span, const ColorCensus& colors) {
        const ClipTiming timing{drawing_.frames_a_second, drawing_.speed, span.to - span.from};
        auto clip = ClipFile::open(*drawing_.format, {.path = drawing_.out,
                                                      .width = canvas_.width(),
                                                      .height = canvas_.height(),
                                                      .frames_a_second = timing.frames_a_second,
                                                      .frames = clip_frames(timing),
                                                      .colors = &colors,
                                                      .dithered = drawing_.dithered});
        if (!clip) return clip.error();
        for (std::uint64_t frame = 0; frame < clip_frames(timing); ++frame) {
            const double time = std::min(span.from + clip_time(timing, frame), span.to);
            if (Status there = go_to(time); !there) return there;
            if (work_.interrupted()) return Error{"interrupted; nothing was written"};
            if (Status added = (*clip)->add(picture()); !added) return added;
        }
        return (*clip)->finish();
    }

private:
    const PreserveDrawing& drawing_;
    PastWorld& world_;
    PictureCanvas& canvas_;
    LongWork& work_;
    ThreadPool pool_;
    PreserveCamera camera_;
    std::uint64_t begun_;  // tick
};

}  // namespace

Status draw_preserve(const PreserveDrawing& drawing, const EvolutionKinds& kinds, LongWork& work) {
    const Result<SavedPreserve> saved = load_preserve(drawing.file, kinds);
    if (!saved) return saved.error();
    const Result<Span> span = span_of(drawing, *saved);
    if (!span) return span.error();
    if (saved->origin.simulator != kSimulatorVersion) {
        say(
            fmt::format("{}: it was begun by simulator {}, this is {}; the motion may be another "
                        "one than it was",
                        drawing.file, saved->origin.simulator, kSimulatorVersion));
    }
    const SnapshotEntry& before = snapshot_before(*saved, span->from);
    auto world = PastWorld::at(drawing.file, *saved, before, saved->snapshots.back().tick, kinds);
    if (!world) return Error{drawing.file + ": " + world.error().message};
    const auto workshop = open_workshop(drawing.width, drawing.height);
    if (!workshop) return workshop.error();
    Drawer drawer(drawing, *world, *(*workshop)->canvas, work);
    work.begin("drawing", span->to - seconds_of(before));
    if (Status there = drawer.go_to(span->from); !there) return there;
    if (drawing.format == nullptr) return drawer.write_picture();
    return drawer.write_clip(*span, census_of(*drawing.format, [&](int i) {
        const double time = span->from + (span->to - span->from) * i / (kCountedPictures - 1);
        const auto past = PastWorld::at(drawing.file, *saved, snapshot_before(*saved, time),
                                        saved->snapshots.back().tick, kinds);
        return drawer.picture_of(past ? *past : *world);
    }));
}

}  // namespace cambrian
