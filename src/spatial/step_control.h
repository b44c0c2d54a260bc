#pragma once

// The time loop of one tick: contacts and stops, attempts of steps, acceptance, impacts, energy
// audit (planar/README.md 15, 16).

#include "dynamics/step_policy.h"
#include "spatial/steps.h"
#include "spatial/time_of_impact.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

namespace cambrian::spatial {

// The impacts of a body on the ground, or of two bodies, in one tick.
struct NotedImpact {
    int body = 0;
    int other_body = -1;
    int part = 0;  // those of the first contact
    int other_part = -1;
    double impulse = 0.0;       // N s, sum of the normal impulses
    double lost = 0.0;          // J, kinetic energy
    Vec3 point = Vec3::Zero();  // m, world; sum weighted by the impulse
};

// All data of a scene that change with time; a copy is a saved state.
struct State {
    Motion motion;
    double time = 0.0;  // s
    SceneStatus status = SceneStatus::kRunning;
    double proposed_step = 1.0 / 120;  // s
    // Of the last step, if it was a midpoint step and no impact followed.
    MotionRate last_rate;
    bool has_last_rate = false;
    double evaluation_debt = 0.0;  // evaluations above the allowance of the simulated time
    Drive drive;
    SceneAudit audit;
    double energy_reference = 0.0;  // J, at the start of the audit
    struct SpecificForce {
        Vec3 value = Vec3::Zero();  // m/s^2
    };
    SpecificForce specific_force[kMostParts];  // means of the last tick, of the measured parts
    // Of the motion, free of stops.
    OwnedEvaluation evaluation;
    MotionRate rate;
    bool is_current = false;  // whether these two are those of the motion
    HeldContacts held;        // of the last step
    // Of the last tick:
    std::uint8_t touched[kMostParts] = {};  // bit of every Face
    double load[kMostParts] = {};  // N, mean of the normal forces; within a tick N s so far
    int impact_count = 0;
    NotedImpact impacts[kMostImpacts];
};

class StepControl {
public:
    StepControl(const Model& model, const Integrator& integrator, const SceneSettings& settings);

    // Advances the state by one tick (s); its status says whether that succeeded.
    void advance(const Model& model, Forcing& forcing, double duration, State& state);

private:
    struct Tick : step_policy::Course {
        const Model& model;
        const Forcing& forcing;
        State& state;
    };
    using Attempt = step_policy::Attempt;

    SceneStatus step(Tick& tick);
    static void make_current(Tick& tick);
    double choose_length(Tick& tick, bool& has_rows);
    Attempt attempt(Tick& tick, bool has_rows, double& h);
    void try_step(Tick& tick, bool has_rows, double h);
    void apply_impact(Tick& tick, double restitution);
    void note_impacts(Tick& tick);
    void detect(const Tick& tick, const Motion& motion, const Kinematics& kinematics);
    bool has_impact() const;
    bool rests(const Tick& tick) const;
    bool must_halve(const Tick& tick, double h);
    double unexplained_gain(const Tick& tick) const;
    void accept(Tick& tick, bool has_rows, double h);
    void accept_part(Tick& tick, bool has_rows, double h);
    void add_to_audit(Tick& tick, double share);

    const Integrator* integrator_;
    step_policy::Limits limits_;
    ContactSet near_;
    Rows rows_;
    MidpointStep midpoint_;
    OwnedEvaluation end_;  // of the present attempt
    StepResult result_;
    RowWork work_;  // of the present attempt
    // Of a step that an impact ends: the rates at its ends, and the motion where it happens.
    MotionRate first_, last_;
    Motion part_;
};

}  // namespace cambrian::spatial
