#pragma once

// The time loop of one tick: contact forces, attempts of steps, acceptance, impacts, energy audit
// (planar/README.md 15).

#include "dynamics/step_policy.h"
#include "planar/constraints/contact_solver.h"
#include "planar/stepping/midpoint_step.h"
#include "planar/stepping/time_of_impact.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <memory>
#include <optional>

namespace cambrian {

// Forces on the measured parts, as means over a tick, for sensors.
struct PartForces {
    PerPart speed_x = {}, speed_y = {};        // m/s, of the part's centre at the end of the tick
    PerPart specific_x = {}, specific_y = {};  // m/s^2, acceleration of the centre minus gravity
    PerPart load = {};  // N, sum of the normal forces; during a tick, the impulse in N s so far
};

// A contact of the last solved step, for display.
struct HeldContact {
    int body_a = 0;
    double point_x = 0.0, point_y = 0.0;    // m, in body a's frame
    double normal_x = 0.0, normal_y = 0.0;  // unit, out of the surface touched
    double force = 0.0;                     // N
};

// The impacts of a body on another or on the ground in one tick.
struct NotedImpact {
    int body_a = 0, body_b = -1;          // -1: the ground
    int part_a = 0, part_b = -1;          // those of the first contact
    double impulse = 0.0;                 // N s, sum of the normal impulses
    double lost = 0.0;                    // J, kinetic energy
    double point_x = 0.0, point_y = 0.0;  // m, world; sums weighted by the impulse
    const PhysicsScene* other = nullptr;  // of body b, if it is another one
};

// Works of the motors of one of several creatures during a tick, J.
struct MemberWork {
    double net = 0.0, gross = 0.0;
};

// The data of a scene that change with time, but for what can be computed again.
struct SceneMoment {
    Motion motion = {};
    double time = 0.0;  // s
    SceneStatus status = SceneStatus::kRunning;
    double proposed_step = 1.0 / 120;  // s
    // Accelerations of the last step, if it was a midpoint step and no impact followed.
    PerCoordinate last_acceleration = {};
    bool has_last_acceleration = false;
    double evaluation_debt = 0.0;  // evaluations above the allowance of the simulated time
    WarmStart warm;
    PerBody drive_start = {}, drive_end = {};  // motor targets
    std::uint8_t touched[kMaxParts] = {};      // bit of every Face that touched in the last tick
    PartForces forces;                         // of the last tick; 0 but for the measured parts
    int held_count = 0;
    HeldContact held[kMaxContacts];
    int impact_count = 0;  // of the last tick
    NotedImpact impacts[kMostImpacts];
    SceneAudit audit;
    double energy_reference = 0.0;      // J, at the start of the audit
    MemberWork member_work[kMaxTrees];  // of several creatures; summed since it was set to 0
    // Of the trees that nothing outside has touched since, each named by the bit of its root: the
    // angular momentum about its centre less motion.work[kSpinGiven], kg m^2/s.
    PerTree spin = {};
    BodySet known_spins = 0;
};

// A cache on the heap, so that two of them are exchanged without copying numbers.
class OwnedCache {
public:
    OwnedCache() : cache_(std::make_unique<EvaluationCache>()) {}
    OwnedCache(const OwnedCache& other) : cache_(std::make_unique<EvaluationCache>(other.get())) {}
    OwnedCache& operator=(const OwnedCache& other) {
        *cache_ = other.get();
        return *this;
    }
    EvaluationCache& get() { return *cache_; }
    const EvaluationCache& get() const { return *cache_; }
    void swap(OwnedCache& other) { cache_.swap(other.cache_); }

private:
    std::unique_ptr<EvaluationCache> cache_;
};

// All data of a scene that change with time; a copy is a saved state.
struct SimulationState : SceneMoment {
    OwnedCache owned_cache;     // of the motion, free of contact forces
    MotionRate free_rate = {};  // of the motion, free of contact
    bool cache_is_current = false;
    std::optional<double> energy;  // J, mechanical, of the current cache if it was computed
    // Number of the contact detection for this motion; 0 if there is none.
    std::uint64_t detection = 0;

    EvaluationCache& cache() { return owned_cache.get(); }
    const EvaluationCache& cache() const { return owned_cache.get(); }
};

// Numbers of complementarity problems since the start, and of those in which the solver failed.
struct SolverTally {
    std::uint64_t resting = 0, resting_failed = 0;
    std::uint64_t impacts = 0, impacts_failed = 0;
};

// These decide which numbers of a cache are computed.
struct ComputedParts {
    NumberCounts counts;
    int dense_blocks = 0;
    bool has_slides = false, has_stretches = false;

    friend bool operator==(const ComputedParts&, const ComputedParts&) = default;
    // Whether the same numbers are computed of each body as of another model's.
    bool is_alike(const ComputedParts& other) const {
        return (dense_blocks > 0) == (other.dense_blocks > 0) && has_slides == other.has_slides &&
               has_stretches == other.has_stretches;
    }
};

class StepControl {
public:
    StepControl(const IntegratorKind& integrator, const SceneSettings& settings);

    // Advances the state by one tick; its status says whether that succeeded.
    void advance(const PlanarModel& model, const ContactLaw& law, Forcing& forcing, double duration,
                 SimulationState& state);

    // Must be called before the first model and before another one is advanced.
    void change_model(const PlanarModel& model);

    const SolverTally& solver_tally() const { return solver_tally_; }

private:
    struct Tick : step_policy::Course {
        const PlanarModel& model;
        const ContactLaw& law;
        Forcing& forcing;
        SimulationState& state;
        // The last step ended where two boxes met that would have passed each other.
        bool must_stop = false;
    };
    void clear_all();
    void clear_beyond(const ChangedCounts& counts);
    using Attempt = step_policy::Attempt;

    SceneStatus step(Tick& tick);
    static void roll_back(Tick& tick, const Motion& start, const SceneAudit& audit_before);
    static void make_current(Tick& tick);
    void apply_impact(Tick& tick, double restitution);
    double choose_length(Tick& tick, bool& has_rows);
    void count_resting(Tick& tick, bool solved);
    Attempt attempt(Tick& tick, bool has_rows, double& h);
    bool is_midpoint(bool has_rows) const { return has_rows && integrator_->rows_at_middle; }
    void try_midpoint_step(Tick& tick, double h);
    void try_step(Tick& tick, bool has_rows, double h);
    const MotionRate& held_start_rate(Tick& tick);
    void respond_to_held(const Tick& tick, BodyResponse& response) const;
    void check_step_end(const Tick& tick);
    std::optional<double> look_for_crossing(const Tick& tick, const StepEnds& ends,
                                            double start_depth);
    void reject_end(Tick& tick, double h);
    bool must_halve(const Tick& tick, double h);
    double unexplained_gain(const Tick& tick);
    void accept(Tick& tick, bool has_rows, double h);
    void accept_part(Tick& tick, double h, double share);
    void release_forces(Tick& tick);
    void add_to_audit(Tick& tick, double time);
    void remember_contacts(Tick& tick);
    static SceneStatus status_of(const Tick& tick);

    const IntegratorKind* integrator_;
    step_policy::Limits limits_;
    ContactSolver contacts_;
    MidpointStep midpoint_;
    OwnedCache spare_;             // scratch space for the end of an attempt
    std::uint64_t detection_ = 1;  // number of the last detection
    MotionRate held_rate_ = {};
    const MotionRate* start_rate_ = nullptr;  // of the present attempt, under its forces
    const MotionRate* end_rate_ = nullptr;    // at its end
    SolverTally solver_tally_;
    StepResult result_;
    HeldWork work_;                     // of the present attempt
    double end_overrun_ = 0.0;          // rad or m; at its end
    std::optional<double> end_energy_;  // J, there, if it was computed
    ComputedParts computed_;  // by the present model and those since the memory was set to 0
};

}  // namespace cambrian
