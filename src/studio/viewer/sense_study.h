#pragma once

// Finds what the displayed creature loses without its senses, on a thread of its own, since that
// takes some hundred trials.

#include "evolution/evaluation/sense_losses.h"
#include "studio/background/background_worker.h"
#include "studio/playback/exhibit.h"

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>

namespace cambrian {

class SenseStudy {
public:
    // `kinds` must outlive the object.
    explicit SenseStudy(const EvolutionKinds& kinds) : kinds_(kinds) {}

    // Gives up the study before, if one runs.
    void begin(const Exhibit& exhibit);
    // Gives up a study that runs and forgets what was found.
    void clear();
    // Must be called once a frame; takes what is finished.
    void update() { worker_.deliver(); }

    bool running() const { return running_ != nullptr; }
    double share() const { return running_ ? running_->share.load() : 0.0; }  // done, 0 to 1
    // Null until a study is finished.
    const SenseLosses* losses() const { return losses_ ? &*losses_ : nullptr; }

private:
    struct Running {
        std::atomic<double> share = 0.0;
        std::stop_source stop;
    };

    const EvolutionKinds& kinds_;
    std::shared_ptr<Running> running_;
    std::optional<SenseLosses> losses_;
    BackgroundWorker worker_;  // last member, so that it ends before the others
};

}  // namespace cambrian
