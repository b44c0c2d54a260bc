#pragma once

// The creature on display and its trial, tick by tick. It is the same trial that scores it, with
// the actions of the person.

#include "core/result.h"
#include "studio/playback/exhibit.h"
#include "studio/playback/replay.h"
#include "studio/playback/shown_motion.h"
#include "studio/playback/trial_readings.h"

#include <memory>
#include <optional>

namespace cambrian {

class PlayedCreature {
public:
    // Must outlive it.
    explicit PlayedCreature(const Kinds& kinds) : kinds_(&kinds) {}

    // Expresses the creature and starts its trial; on failure the creature before stays.
    Status show(Exhibit exhibit);
    // Starts its trial again, as judged, except that an environment changed by hand is kept.
    void restart();
    void tick();
    // Goes back to the last kept moment at or before the tick.
    void go_back(std::uint64_t tick);
    // Shows a moment between the last two ticks; 1 is the last.
    void show_moment(double share) { motion_.show(share); }
    void show_present() { motion_.jump_to(replay_->trial().scene()); }

    // Acts from the next tick on.
    void set_environment(const Environment& environment);
    // Pulls a part by a point towards a place in the world until told to pull nothing; marks the
    // motion as disturbed until restarted, or until the moment shown lies before the pull.
    void pull(std::optional<Hold> hold) { hold_ = hold; }
    // From the next tick on a neuron has this value, whatever it computes, until restarted or
    // forced to nothing; disturbs as a poke does.
    void force(std::size_t neuron, std::optional<double> value);

    bool empty() const { return replay_ == nullptr; }
    const Exhibit& exhibit() const { return exhibit_; }
    // The rest only if it is not empty.
    const std::shared_ptr<const Phenotype>& shared_phenotype() const { return phenotype_; }
    const Phenotype& phenotype() const { return *phenotype_; }
    // Its environment is what judges the creature, or what it was changed to by hand.
    const Replay& replay() const { return *replay_; }
    const ShownMotion& motion() const { return motion_; }
    const TrialReadings& readings() const { return readings_; }
    bool disturbed() const { return !empty() && (hold_ || replay_->disturbed()); }
    // What the mouse holds, or null.
    const Hold* hold() const { return hold_ ? &*hold_ : nullptr; }

private:
    void begin(std::unique_ptr<Replay> replay);

    const Kinds* kinds_;
    Exhibit exhibit_;
    std::shared_ptr<const Phenotype> phenotype_;
    std::unique_ptr<Replay> replay_;
    ShownMotion motion_;
    TrialReadings readings_;
    std::optional<Hold> hold_;
};

}  // namespace cambrian
