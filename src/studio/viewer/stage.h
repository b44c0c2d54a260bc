#pragma once

// The playback of the displayed creature, and its score from the same trial in the background.

#include "evolution/kinds/evolution_kinds.h"
#include "studio/background/background_worker.h"
#include "studio/playback/playback.h"

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>

namespace cambrian {

class Stage {
public:
    // Both must outlive it.
    Stage(BackgroundWorker& worker, const EvolutionKinds& kinds)
        : worker_(worker), kinds_(kinds), playback_(kinds.creature) {}

    Status show(Exhibit exhibit);
    Playback& playback() { return playback_; }
    const Playback& playback() const { return playback_; }
    // Null until computed.
    const ScoreReport* score() const { return score_ ? &*score_ : nullptr; }

private:
    void request_score();

    BackgroundWorker& worker_;
    const EvolutionKinds& kinds_;
    Playback playback_;
    std::optional<ScoreReport> score_;
    // Set once another creature has taken the place of the one being scored.
    std::shared_ptr<std::atomic<bool>> outdated_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace cambrian
