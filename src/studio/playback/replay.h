#pragma once

// A trial that can be gone back in: a moment is kept every so often, and from the last one before
// the moment sought it runs again, to the same bits, hands and changed worlds included.

#include "core/result.h"
#include "simulator/trial.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace cambrian {

// A point of a part pulled towards a place in the world.
struct Hold {
    std::size_t part = 0;
    Vec3 point_in_part = Vec3::Zero();  // m
    Vec3 target = Vec3::Zero();         // m, world
};

class Replay {
public:
    // Fails if physics refuses the body.
    static Result<std::unique_ptr<Replay>> start(std::shared_ptr<const Phenotype> phenotype,
                                                 const Kinds& kinds, const TrialWorld& world);

    const Trial& trial() const { return *trial_; }
    std::uint64_t ticks() const { return trial_->ticks(); }
    bool diverged() const { return trial_->scene().status() != SceneStatus::kRunning; }

    // One tick on, pulled by a hand if there is one. While a known course is repeated, it is pulled
    // as it was then.
    void tick(const Hold* hold = nullptr);
    // Goes back to the last kept moment at or before `tick`, which must not lie ahead; ticking on
    // to it repeats the course. Hands after it are forgotten and the present environment holds from
    // there.
    void go_back(std::uint64_t tick);

    // Felt from the next tick on, or from where the repeated course ends.
    void set_environment(const Environment& environment);
    const Environment& environment() const { return changes_.back().environment; }
    // What neurons say instead of what they compute; the same holds for it.
    void set_forced(const std::map<std::size_t, double>& forced);
    const std::map<std::size_t, double>& forced() const { return changes_.back().forced; }
    // Whether a hand pulled, or a neuron was forced, up to now.
    bool disturbed() const;

private:
    struct Kept {
        std::uint64_t tick = 0;
        Trial::State state;
    };
    struct Pull {
        std::uint64_t tick = 0;
        Hold hold;
    };
    // What holds from a tick on.
    struct Change {
        std::uint64_t tick = 0;
        Environment environment;
        std::map<std::size_t, double> forced = {};
    };

    explicit Replay(std::unique_ptr<Trial> trial);
    void keep();
    void pull(const Hold& hold);
    const Hold* known_hold() const;
    // In force when the tick of that number began being computed, changes at that very tick aside.
    const Change& change_before(std::uint64_t tick) const;
    void change_from_now(Change change);
    void apply(const Change& change);
    std::vector<Change>::const_iterator first_change_from(std::uint64_t tick) const;

    std::unique_ptr<Trial> trial_;
    std::vector<Kept> kept_;       // by tick; the first is the start
    std::uint64_t spacing_;        // ticks between two kept moments
    std::vector<Pull> pulls_;      // by tick
    std::vector<Change> changes_;  // by tick, one each; before them the world it started in
    std::uint64_t known_until_ = 0;
};

}  // namespace cambrian
