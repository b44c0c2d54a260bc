#pragma once

// The displayed creature and its trial, tick by tick. The trial is one of those that are scored,
// plus what the user does to it.

#include "core/result.h"
#include "creature/lesion.h"
#include "studio/playback/exhibit.h"
#include "studio/playback/replay.h"
#include "studio/playback/shown_bout.h"
#include "studio/playback/shown_motion.h"
#include "studio/playback/trial_readings.h"

#include <memory>
#include <optional>
#include <vector>

namespace cambrian {

class PlayedCreature {
public:
    // `kinds` must outlive the object.
    explicit PlayedCreature(const Kinds& kinds) : kinds_(&kinds) {}

    // Expresses the creature and starts the first of its trials. On failure, the creature before
    // stays.
    Status show(Exhibit exhibit);
    // Starts the present trial with these lesions, or with none: indices are those of whole(). On
    // failure, the motion before stays.
    Status deprive(std::vector<Lesion> lesions);
    // Starts another of the trials that its score combines, counted from 0.
    void show_trial(int trial);
    int trial_number() const { return replay_->trial().world().light.trial; }
    // Restarts the trial as it was evaluated; an environment changed by the user is kept.
    void restart();
    void tick();
    // Goes back to the last stored state at or before the tick.
    void go_back(std::uint64_t tick);
    // Displays an instant between the last two ticks; 1 is the last tick.
    void show_moment(double share) {
        motion_.show(share);
        bout_.show(share);
    }
    void show_present() {
        motion_.jump_to(replay_->trial().scene());
        bout_.jump_to(replay_->trial().bout());
    }

    // Replaces the scores of the displayed creature by those of an audit; the motion goes on.
    void rejudge(IndividualPtr individual) { exhibit_.creature.individual = std::move(individual); }
    // Changes the environment from the next tick on.
    void set_environment(const Environment& environment);
    // Pulls a point of a part towards a point in the world until called with nothing. The motion
    // counts as disturbed until it is restarted or goes back to before the pull.
    void pull(std::optional<Hold> hold) { hold_ = std::move(hold); }
    // Forces the value of a neuron from the next tick on, until restarted or called with nothing.
    // This also disturbs the motion.
    void force(std::size_t neuron, std::optional<double> value);

    bool empty() const { return replay_ == nullptr; }
    const Exhibit& exhibit() const { return exhibit_; }
    // The following functions may be called only if the object is not empty.
    const std::shared_ptr<const Phenotype>& shared_phenotype() const { return phenotype_; }
    const Phenotype& phenotype() const { return *phenotype_; }
    // The creature without its lesions.
    const Phenotype& whole() const { return *whole_; }
    const std::vector<Lesion>& lesions() const { return lesions_; }
    // Its environment is the one that evaluated the creature, unless the user changed it.
    const Replay& replay() const { return *replay_; }
    const ShownMotion& motion() const { return motion_; }
    const ShownBout& bout() const { return bout_; }  // of a contest only
    const TrialReadings& readings() const { return readings_; }
    // The present pull of the mouse, or null.
    const Hold* hold() const { return hold_ ? &*hold_ : nullptr; }

private:
    Status begin(std::shared_ptr<const Phenotype> whole, std::vector<Lesion> lesions,
                 const TrialWorld& world);
    void begin(std::unique_ptr<Replay> replay);

    const Kinds* kinds_;
    Exhibit exhibit_;
    std::shared_ptr<const Phenotype> whole_;
    std::vector<Lesion> lesions_;
    std::shared_ptr<const Phenotype> phenotype_;  // `whole_` with the lesions
    std::unique_ptr<Replay> replay_;
    ShownMotion motion_;
    ShownBout bout_;
    TrialReadings readings_;
    std::optional<Hold> hold_;
};

// Returns whether the user has changed the motion.
inline bool is_disturbed(const PlayedCreature& creature) {
    return !creature.empty() && (creature.hold() != nullptr || creature.replay().disturbed());
}

}  // namespace cambrian
