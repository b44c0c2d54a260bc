#pragma once

// The first creatures of a run before any is judged: those that its seed gives, each in a trial of
// its own, recorded in the background.

#include "evolution/individual/judged_individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "studio/hand_picking/grid_motion.h"

#include <cstddef>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kMostFounders = 20;

class FounderCrowd {
public:
    // `kinds` must outlive it.
    explicit FounderCrowd(const EvolutionKinds& kinds) : kinds_(kinds), motion_(kinds.creature) {}

    // Takes the first creatures of generation 0 of a run of random creatures, and starts their
    // trials.
    void show(const SettingsPtr& settings);
    // Must be called once a frame.
    void advance(double elapsed) { motion_.advance(elapsed); }

    const std::vector<IndividualPtr>& founders() const { return founders_; }
    const GridMotion& motion() const { return motion_; }
    const SettingsPtr& settings() const { return settings_; }
    // Returns the side of a square as large as the body of a big one of them, in m.
    double big_body() const { return big_body_; }

private:
    const EvolutionKinds& kinds_;
    GridMotion motion_;
    SettingsPtr settings_;
    std::vector<IndividualPtr> founders_;
    double big_body_ = 0.0;
};

}  // namespace cambrian
