#pragma once

// A trial that can go back in time. It stores states at intervals and recomputes from the last
// state before the tick sought. The bits are the same, with all pulls and changes of the world.

#include "core/result.h"
#include "simulator/trial.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace cambrian {

// A pull on a point of a part towards a point in the world.
struct Hold {
    std::size_t part = 0;
    Vec3 point_in_part = Vec3::Zero();  // m, in the part's frame
    Vec3 target = Vec3::Zero();         // m, in the world
};

class Replay {
public:
    // Fails if physics rejects the body.
    static Result<std::unique_ptr<Replay>> start(std::shared_ptr<const Phenotype> phenotype,
                                                 const Kinds& kinds, const TrialWorld& world);

    const Trial& trial() const { return *trial_; }
    std::uint64_t ticks() const { return trial_->ticks(); }
    bool diverged() const { return trial_->scene().status() != SceneStatus::kRunning; }

    // Advances one tick, with the pull `hold` if not null. At ticks that were computed before, the
    // pull of that time is repeated instead.
    void tick(const Hold* hold = nullptr);
    // Goes back to the last stored state at or before `tick`, which must not be later than ticks().
    // Ticking on repeats the motion up to `tick`. Pulls after it are forgotten, and the present
    // environment holds from it on.
    void go_back(std::uint64_t tick);

    // Changes the environment from the next tick on or, while motion is repeated, from its end on.
    void set_environment(const Environment& environment);
    const Environment& environment() const { return changes_.back().environment; }
    // Sets the values that neurons have instead of the computed ones, from the same tick on.
    void set_forced(const std::map<std::size_t, double>& forced);
    const std::map<std::size_t, double>& forced() const { return changes_.back().forced; }
    // Returns whether anything was pulled, or a neuron was forced, so far.
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
    // The environment and forced values that hold from a tick on.
    struct Change {
        std::uint64_t tick = 0;
        Environment environment;
        std::map<std::size_t, double> forced = {};
    };

    explicit Replay(std::unique_ptr<Trial> trial);
    void keep();
    void pull(const Hold& hold);
    const Hold* known_hold() const;
    // Returns the change in force before a tick; changes at that tick itself do not count.
    const Change& change_before(std::uint64_t tick) const;
    void change_from_now(Change change);
    void apply(const Change& change);
    std::vector<Change>::const_iterator first_change_from(std::uint64_t tick) const;

    std::unique_ptr<Trial> trial_;
    std::vector<Kept> kept_;   // ordered by tick; the first is the start
    std::uint64_t spacing_;    // ticks between two stored states
    std::vector<Pull> pulls_;  // ordered by tick
    // Ordered by tick, one per tick; the first is the world at the start.
    std::vector<Change> changes_;
    std::uint64_t known_until_ = 0;
};

}  // namespace cambrian
