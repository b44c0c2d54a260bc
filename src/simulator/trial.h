#pragma once

// One creature in one world: settle, then tick by tick sense, think, act, advance, record. The
// studio plays a Trial tick by tick, evaluation runs it to the end: what is seen is what was
// scored.

#include "core/hash.h"
#include "core/result.h"
#include "creature/creature.h"
#include "simulator/rest_watch.h"
#include "simulator/reversals.h"
#include "simulator/trial_record.h"
#include "simulator/trial_settings.h"
#include "simulator/trial_surroundings.h"
#include "world/environment.h"
#include "world/physics_scene.h"

#include <cstdint>
#include <memory>
#include <stop_token>

namespace cambrian {

// Everything a trial depends on besides the phenotype.
struct TrialWorld {
    Environment environment;
    SceneSettings scene;
    TrialSettings trial;

    friend bool operator==(const TrialWorld&, const TrialWorld&) = default;
};

class Trial {
    // How far it is, and what was seen so far.
    struct Progress {
        TrialRecord record = {};
        Hash64 digest = {};
        std::vector<ReversalCounter> reversals = {};  // one an effector part
        RestWatch rest;
        std::uint64_t total_ticks = 0;
        std::uint64_t test_ticks = 0;
        int calm_ticks = 0;
        int deep_ticks = 0;
        bool settling = false;
        bool finished = false;
    };

public:
    // Places the creature in its start pose. Fails if physics refuses the body.
    static Result<std::unique_ptr<Trial>> start(std::shared_ptr<const Phenotype> phenotype,
                                                const Kinds& kinds, const TrialWorld& world);
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    // Advances by one tick of 1/60 s. Returns false once the test phase is over or the trial
    // failed; the motion may then go on being watched with tick(), unless it diverged, but is not
    // recorded.
    bool tick();

    bool settling() const { return progress_.settling; }
    bool finished() const { return progress_.finished; }
    // Ends it with the outcome kInterrupted if a stop is asked for and it has become long; ordinary
    // trials are better finished.
    void heed(const std::stop_token& stop);
    double time() const {
        return static_cast<double>(progress_.test_ticks) * kBrainTick;
    }                                                              // s, of the test phase
    std::uint64_t ticks() const { return progress_.total_ticks; }  // settling included
    std::uint64_t settle_ticks() const {
        return progress_.total_ticks - progress_.test_ticks;
    }  // so far

    const TrialWorld& world() const { return world_; }
    const Phenotype& phenotype() const { return *phenotype_; }
    PhysicsScene& scene() { return *scene_; }
    const PhysicsScene& scene() const { return *scene_; }
    const Surroundings& surroundings() const { return surroundings_; }
    // Changes the scene and what the creature senses from the next tick on, as a person does while
    // watching. world() stays as it was.
    void set_environment(const Environment& environment);
    Creature& creature() { return creature_; }
    const Creature& creature() const { return creature_; }
    // Everything that changes from tick to tick.
    struct State {
        std::unique_ptr<SceneState> scene;
        Creature::State creature;
        Progress progress;
    };
    State save() const;
    // Back to a moment saved by this trial, to go on from there with the same bits. The scene must
    // have the environment it had then.
    void restore(const State& state);
    // Ends the test phase now, as if nothing moved any more: further samples repeat the last one.
    void stop_early(Outcome outcome, std::string reason);
    // Complete once finished().
    const TrialRecord& record() const { return progress_.record; }
    TrialRecord take_record() { return std::move(progress_.record); }

private:
    Trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds, const TrialWorld& world,
          std::unique_ptr<PhysicsScene> scene);
    void place_at_start();
    void settle_tick();
    void test_tick();
    void begin_test();
    void watch_jumps();
    void sample();
    void check_guards();
    void fail_with(SceneStatus status);
    void fail(Outcome outcome, std::string reason);
    void finish();

    std::shared_ptr<const Phenotype> phenotype_;
    TrialWorld world_;
    std::unique_ptr<PhysicsScene> scene_;
    TrialSurroundings surroundings_;
    Creature creature_;
    Progress progress_;
};

// A complete trial. One that has become long gives up when asked to stop, with the outcome
// kInterrupted; ordinary ones are finished first.
Result<TrialRecord> run_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                              const TrialWorld& world, const std::stop_token& stop = {});

}  // namespace cambrian
