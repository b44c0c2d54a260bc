#pragma once

// Champions of other generations that are displayed beside the creature for comparison. Each runs a
// trial of its own, and all tests begin at the same time.

#include "evolution/engine/snapshot.h"
#include "studio/look/view_state.h"
#include "studio/playback/playback.h"

#include <memory>
#include <span>
#include <vector>

namespace cambrian {

// Chooses among the champions, oldest first. The displayed genome is left out and no genome occurs
// twice.
std::vector<const JudgedIndividual*> choose_ghosts(const std::vector<JudgedIndividual>& champions,
                                                   GhostChoice choice, const Genome* shown);

class Ghost {
public:
    // Returns null if physics rejects the body.
    static std::unique_ptr<Ghost> start(const JudgedIndividual& champion, const Kinds& kinds,
                                        const Environment& environment);

    // Moves one tick towards the tick of the displayed creature; returns false once there.
    bool follow(const Playback& playback);
    void show(double share) { motion_.show(share); }

    std::uint32_t generation() const { return champion_.generation; }
    std::uint64_t line() const { return champion_.individual->line; }  // uid of its founder
    const Genome& genome() const { return *champion_.individual->genome; }
    const Phenotype& phenotype() const { return replay_->trial().phenotype(); }
    const Trial& trial() const { return replay_->trial(); }
    const std::vector<Pose>& poses() const { return motion_.poses(); }
    const std::vector<double>& stretches() const { return motion_.stretches(); }

private:
    Ghost(JudgedIndividual champion, std::unique_ptr<Replay> replay);
    bool go_back(std::uint64_t tick);

    JudgedIndividual champion_;
    std::unique_ptr<Replay> replay_;
    ShownMotion motion_;
};

class Ghosts {
public:
    // `kinds` must outlive the object.
    explicit Ghosts(const Kinds& kinds) : kinds_(&kinds) {}

    // Must be called once a frame, after the displayed creature moved. Adds and removes ghosts as
    // chosen, at most one new one per frame, and moves all, for at most `budget` seconds.
    void update(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback,
                double budget);
    std::span<const std::unique_ptr<Ghost>> all() const { return ghosts_; }

private:
    void choose(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback);
    void call_next(const Environment& environment);

    const Kinds* kinds_;
    std::vector<std::unique_ptr<Ghost>> ghosts_;
    std::vector<JudgedIndividual> called_;  // chosen but not yet started
    // The data from which the ghosts were chosen.
    struct Basis {
        std::uint64_t experiment = 0;
        std::size_t champions = 0;
        GhostChoice choice = GhostChoice::kNone;
        GenomePtr shown;
        friend bool operator==(const Basis&, const Basis&) = default;
    };
    Basis basis_;
};

}  // namespace cambrian
