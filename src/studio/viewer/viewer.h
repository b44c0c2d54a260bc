#pragma once

// The displayed creature's playback, and its score, which a background job computes from the same
// trial.

#include "evolution/kinds/evolution_kinds.h"
#include "studio/background/background_worker.h"
#include "studio/playback/playback.h"

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>

namespace cambrian {

class Viewer {
public:
    // Both references must outlive the object.
    Viewer(BackgroundWorker& worker, const EvolutionKinds& kinds)
        : worker_(worker), kinds_(kinds), playback_(kinds.creature) {}

    Status show(Exhibit exhibit);
    Playback& playback() { return playback_; }
    const Playback& playback() const { return playback_; }
    // Null until the score is computed.
    const ScoreReport* score() const { return score_ ? &*score_ : nullptr; }

private:
    void request_score();

    BackgroundWorker& worker_;
    const EvolutionKinds& kinds_;
    Playback playback_;
    std::optional<ScoreReport> score_;
    // Set when another creature replaces the one being scored.
    std::shared_ptr<std::atomic<bool>> outdated_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace cambrian
