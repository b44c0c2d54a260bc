#pragma once

// One creature in one world. After settling, each tick reads the sensors, evaluates the brain, sets
// the motors, advances physics and records. The studio and the evaluation use the same class, so
// the displayed motion is the scored one.

#include "core/hash.h"
#include "core/result.h"
#include "creature/creature.h"
#include "simulator/contest/bout.h"
#include "simulator/contest/opponents.h"
#include "simulator/length_meter.h"
#include "simulator/rest_watch.h"
#include "simulator/reversals.h"
#include "simulator/settings/trial_settings.h"
#include "simulator/surroundings/side_wall.h"
#include "simulator/surroundings/trial_surroundings.h"
#include "simulator/trial_record.h"
#include "world/environment.h"
#include "world/physics_scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

namespace cambrian {

class Terrain;

// All that a trial depends on besides the phenotype.
struct TrialWorld {
    Environment environment;
    SceneSettings scene;
    TrialSettings trial;
    // Whom the creature contends with. A run draws them for each generation.
    Opponents opponents;
    // The following are unset in settings and follow from them (evolution/evaluation/trials.h).
    LightDraw light;
    ExpressionSettings expression;  // of the opponents
    // Degrees by which gravity is turned to one side in settling and the first half of the test,
    // and to the other side in the second half, in a confirming world.
    double tilt = 0.0;

    friend bool operator==(const TrialWorld&, const TrialWorld&) = default;
};

// Returns the world with the ground that its chance draws, if that is not always the same.
TrialWorld with_drawn_ground(TrialWorld world);

// Half of its functions only show a part of it to who watches or continues a trial.
class Trial {
    // The progress of the trial and its records so far.
    struct Progress {
        TrialRecord record = {};
        Hash64 digest = {};
        std::vector<ReversalCounter> reversals = {};  // one per effector
        RestWatch rest;
        std::optional<SideWall> wall = {};  // during the test of a world with one
        std::uint64_t total_ticks = 0;
        std::uint64_t test_ticks = 0;
        int calm_ticks = 0;
        int deep_ticks = 0;
        bool settling = false;
        bool finished = false;
    };

public:
    // Places the creature in its start pose. Fails if physics rejects the body.
    static Result<std::unique_ptr<Trial>> start(std::shared_ptr<const Phenotype> phenotype,
                                                const Kinds& kinds, const TrialWorld& world);
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    // Advances by one tick of 1/60 s. Returns false when the test phase is over or the trial
    // failed. Unless it diverged, tick() may still be called to watch the motion, which is not
    // recorded.
    bool tick();

    bool settling() const { return progress_.settling; }
    bool finished() const { return progress_.finished; }
    // Ends a long trial with the outcome kInterrupted if a stop is requested. Ordinary trials are
    // short, so they are finished.
    void poll_cancel(const std::stop_token& stop);
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
    // The cube and the opponent of a contest; null in other trials.
    const Bout* bout() const { return bout_.get(); }
    const TrialSurroundings& surroundings() const { return surroundings_; }
    // The wall on one side, or null before the test and in worlds without one.
    const FixedBox* wall() const { return progress_.wall ? &progress_.wall->box : nullptr; }
    // Changes the environment of the scene and the sensors from the next tick on, when a user edits
    // it. world() does not change.
    void set_environment(const Environment& environment);
    Creature& creature() { return creature_; }
    const Creature& creature() const { return creature_; }
    // All data that change from tick to tick.
    struct State {
        std::unique_ptr<SceneState> scene;
        Creature::State creature;
        TrialSurroundings::Moment surroundings;
        Progress progress;
        std::optional<Bout::State> bout;
    };
    State save() const;
    // Restores a state that this trial saved, and continues with the same bits. The scene must have
    // the environment of that time.
    void restore(const State& state);
    // Ends the test phase now, as if nothing moved any more: the remaining samples repeat the last
    // one.
    void stop_early(Outcome outcome, std::string reason);
    // The record is complete when finished().
    const TrialRecord& record() const { return progress_.record; }
    TrialRecord take_record() { return std::move(progress_.record); }

private:
    // The creature, and what it contends with, if anything.
    struct Bodies {
        std::unique_ptr<PhysicsScene> scene;
        std::unique_ptr<Bout> bout;
    };
    Trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds, const TrialWorld& world,
          Bodies bodies);
    void place_at_start();
    void set_motors_off(bool off);
    SceneStatus settle();
    SceneStatus advance();
    void add_to_digest();
    void settle_tick();
    void test_tick();
    void begin_test();
    void put_up_wall();
    void tilt_back();
    void move_light();
    void pass_on_emissions();
    void watch_reversals();
    void watch_body();
    void sample();
    double distance_to_light() const;
    std::size_t leg_count() const;
    bool rests();
    void check_guards();
    void fail_with(SceneStatus status);
    void fail(Outcome outcome, std::string reason);
    void finish();

    std::shared_ptr<const Phenotype> phenotype_;
    TrialWorld world_;
    std::uint64_t test_length_;              // ticks
    std::shared_ptr<const Terrain> ground_;  // null if it is flat
    std::unique_ptr<PhysicsScene> scene_;
    std::unique_ptr<Bout> bout_;
    TrialSurroundings surroundings_;
    std::vector<SceneImpact> impacts_;  // of the last tick
    Creature creature_;
    LengthMeter length_;
    std::vector<double> coordinates_;  // of the effectors' joints, after the last tick
    Progress progress_;
};

// Runs a complete trial. A long trial ends with the outcome kInterrupted when a stop is requested;
// ordinary ones are finished.
Result<TrialRecord> run_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                              const TrialWorld& world, const std::stop_token& stop = {});

}  // namespace cambrian
