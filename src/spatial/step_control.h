#pragma once

// The time loop of one tick: stops, attempts of steps, acceptance, energy audit
// (planar/README.md 15, 16).

#include "spatial/steps.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

namespace cambrian::spatial {

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
};

class StepControl {
public:
    StepControl(const Integrator& integrator, const SceneSettings& settings);

    // Advances the state by one tick (s); its status says whether that succeeded.
    void advance(const Model& model, Forcing& forcing, double duration, State& state);

private:
    struct Tick {
        const Model& model;
        const Forcing& forcing;
        State& state;
        double length = 0.0;  // s
        double time = 0.0;    // s, since its start
        int underflows = 0;   // in a row
    };
    enum class Attempt : unsigned char { kAccepted, kUnderflow, kDiverged, kOverBudget };

    SceneStatus step(Tick& tick);
    static void make_current(Tick& tick);
    static void count_evaluations(Tick& tick, int evaluations);
    double choose_length(Tick& tick, bool& has_rows);
    Attempt attempt(Tick& tick, bool has_rows, double& h);
    void try_step(Tick& tick, bool has_rows, double h);
    void apply_impact(Tick& tick);
    bool must_halve(const Tick& tick, double h);
    double unexplained_gain(const Tick& tick) const;
    void propose_length(double h, int order, double& proposed) const;
    void accept(Tick& tick, bool has_rows, double h);

    const Integrator* integrator_;
    double tolerance_;
    double contact_step_;     // s; longest step at a stop
    double underflow_step_;   // s; shorter steps at a stop count as an underflow
    double max_evaluations_;  // a simulated second
    LimitRows limits_;
    MidpointStep midpoint_;
    OwnedEvaluation end_;  // of the present attempt
    StepResult result_;
    double limit_work_ = 0.0;     // J, of the present attempt
    double positive_work_ = 0.0;  // J
};

// Restarts the audit at the present state, whose evaluation must be current.
void start_audit(const Model& model, const Medium& medium, State& state);

}  // namespace cambrian::spatial
