#pragma once

// Writes clips on a thread of its own, one after the other, so that other files do not wait.

#include "pictures/clip.h"
#include "pictures/clips/seen_clip.h"
#include "studio/background/background_worker.h"
#include "studio/files/creature_exhibit.h"

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// What the user chooses about a clip of a creature.
struct ClipChoice {
    const ClipFormat* format = nullptr;
    bool card = false;  // a creature card that moves
    int width = 0;      // pixels
    int height = 0;
    double seconds = 0.0;  // s of the trial
    double speed = 1.0;    // 1 is real time
};

// A kind of clip as the window offers it: a format, or a creature card that moves.
struct ClipKind {
    std::string label;
    std::string_view ending;
    const ClipFormat* format = nullptr;
    bool card = false;
};
const std::vector<ClipKind>& clip_kinds();
// Returns the kind that a name's ending means; null for other names.
const ClipKind* clip_kind_of(std::string_view name);
inline bool is_clip_name(std::string_view name) {
    return clip_kind_of(name) != nullptr;
}

// A clip of a creature's trial.
struct TrialClip {
    std::filesystem::path path;
    CreatureDocument document;
    std::string title;  // title for a creature without a name
    ExperimentSettings settings = {};
    ClipChoice choice;
    Palette palette;
    std::optional<std::uint32_t> generation = {};  // of its birth, which cards tell
};

// The clip that is being written.
struct ClipProgress {
    std::string name;    // of its file
    double share = 0.0;  // of it that is drawn, 0 to 1
    bool stopping = false;
};

struct FinishedClip {
    std::filesystem::path path;
    Status status;
    bool stopped = false;  // by the user
};

class ClipMaker {
public:
    // `kinds` must outlive the object.
    explicit ClipMaker(const EvolutionKinds& kinds) : kinds_(kinds) {}

    void make(TrialClip clip);
    void make(const std::filesystem::path& path, const ClipFormat& format, SeenClip seen);
    // Gives up the clip that is being written.
    void stop();
    // Returns what is being written; no name if nothing is.
    ClipProgress progress() const;
    // Must be called once a frame; returns the clips that are finished, each once.
    std::vector<FinishedClip> take_finished();

private:
    struct Making {
        std::filesystem::path path;
        double length = 0.0;  // s
        std::atomic<double> time = 0.0;
        std::stop_source stop;
    };
    void submit(const std::filesystem::path& path, double length,
                std::function<Status(const TrialWatch&)> work);

    const EvolutionKinds& kinds_;
    std::deque<std::shared_ptr<Making>> making_;  // the one being written first
    std::vector<FinishedClip> finished_;
    BackgroundWorker worker_;  // last member, so that it ends before the others
};

}  // namespace cambrian
