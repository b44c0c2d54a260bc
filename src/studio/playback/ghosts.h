#pragma once

// Champions of other generations, and a rival, that are displayed beside the creature for
// comparison. Each runs a trial of its own, and all tests begin at the same time.

#include "evolution/engine/snapshot.h"
#include "studio/look/view_state.h"
#include "studio/playback/playback.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

// Chooses among the champions, oldest first. The displayed genome is left out and no genome occurs
// twice.
std::vector<const JudgedIndividual*> choose_ghosts(const std::vector<JudgedIndividual>& champions,
                                                   GhostChoice choice, const Genome* shown);

// A creature beside champions that is none of them, and the words that name it.
struct Companion {
    JudgedIndividual creature;
    std::string words;
    double travel = 0.0;  // m to the right in its trial; 0 if unknown
};

class Ghost {
public:
    // `words` name it. Returns null if physics rejects the body. `trial` is as in trial_setup().
    static std::unique_ptr<Ghost> start(const Companion& companion, const Kinds& kinds,
                                        const Environment& environment, int trial);

    // Moves one tick towards the tick of the displayed creature; returns false once there.
    bool follow(const Playback& playback);
    // Displays an instant between the last two ticks. A companion that travels the other way than
    // `travel` (m to the right) is displayed as in a mirror, if its world looks the same in one.
    void show(double share, double travel);

    const std::string& words() const { return it_.words; }
    std::uint64_t line() const { return it_.creature.individual->line; }  // uid of its founder
    const Genome& genome() const { return it_.creature.genome(); }
    const Phenotype& phenotype() const { return replay_->trial().phenotype(); }
    const Trial& trial() const { return replay_->trial(); }
    const std::vector<Pose>& poses() const {
        return mirrored_.empty() ? motion_.poses() : mirrored_;
    }
    const std::vector<double>& stretches() const { return motion_.stretches(); }

private:
    Ghost(Companion companion, std::unique_ptr<Replay> replay);
    bool go_back(std::uint64_t tick);

    Companion it_;
    std::unique_ptr<Replay> replay_;
    ShownMotion motion_;
    std::vector<Pose> mirrored_;  // empty unless it is displayed so
};

class Ghosts {
public:
    // `kinds` must outlive the object.
    explicit Ghosts(const Kinds& kinds) : kinds_(&kinds) {}

    // A creature that is displayed beside champions of the experiment; nothing for none.
    void run_beside(std::optional<Companion> companion) { companion_ = std::move(companion); }
    // Must be called once a frame, after the displayed creature moved. Adds and removes ghosts as
    // chosen, at most one new one per frame, and moves all, for at most `budget` seconds. `travel`
    // is how far the displayed creature goes to the right in its trial, in m; 0 if unknown.
    void update(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback,
                double travel, double budget);
    std::span<const std::unique_ptr<Ghost>> all() const { return ghosts_; }

private:
    void choose(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback);
    void call_next(const Trial& beside, const Environment& environment);

    const Kinds* kinds_;
    std::vector<std::unique_ptr<Ghost>> ghosts_;
    std::optional<Companion> companion_;
    std::vector<Companion> called_;  // chosen but not yet started
    // The data from which the ghosts were chosen.
    struct Basis {
        std::uint64_t experiment = 0;
        std::size_t champions = 0;
        GhostChoice choice = GhostChoice::kNone;
        GenomePtr shown;
        GenomePtr companion;
        std::string words;
        friend bool operator==(const Basis&, const Basis&) = default;
    };
    Basis basis_;
    int trial_ = 0;  // of the settings, that all are in
};

}  // namespace cambrian
