#pragma once

// Champions of other generations on the ground of the creature shown, to compare with it: each a
// trial of its own, whose test begins at the same moment.

#include "evolution/engine/snapshot.h"
#include "studio/look/view_state.h"
#include "studio/playback/playback.h"

#include <memory>
#include <span>
#include <vector>

namespace cambrian {

// Which of the champions, oldest first, none of them of this genome and no genome twice.
std::vector<const JudgedIndividual*> choose_ghosts(const std::vector<JudgedIndividual>& champions,
                                                   GhostChoice choice, const Genome* shown);

class Ghost {
public:
    // Null if physics refuses the body.
    static std::unique_ptr<Ghost> start(const JudgedIndividual& champion, const Kinds& kinds,
                                        const Environment& environment);

    // One tick nearer to where the creature shown is, or back to it; false once there.
    bool follow(const Playback& playback);
    void show(double share) { motion_.show(share); }

    std::uint32_t generation() const { return champion_.generation; }
    const Genome& genome() const { return *champion_.individual->genome; }
    const Phenotype& phenotype() const { return replay_->trial().phenotype(); }
    const Trial& trial() const { return replay_->trial(); }
    const std::vector<Pose>& poses() const { return motion_.poses(); }

private:
    Ghost(JudgedIndividual champion, std::unique_ptr<Replay> replay);
    bool go_back(std::uint64_t tick);

    JudgedIndividual champion_;
    std::unique_ptr<Replay> replay_;
    ShownMotion motion_;
};

class Ghosts {
public:
    // Must outlive it.
    explicit Ghosts(const Kinds& kinds) : kinds_(&kinds) {}

    // Once a frame, after the creature shown moved: the chosen ones come and go, one new one a
    // frame, and all follow it, spending at most `budget` seconds.
    void update(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback,
                double budget);
    std::span<const std::unique_ptr<Ghost>> all() const { return ghosts_; }

private:
    void choose(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback);
    void call_next(const Environment& environment);

    const Kinds* kinds_;
    std::vector<std::unique_ptr<Ghost>> ghosts_;
    std::vector<JudgedIndividual> called_;  // still to come
    // What the choice was made from.
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
