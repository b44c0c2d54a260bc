#pragma once

// One step under contact forces by the midpoint rule, implicit for the motors' damping and explicit
// for the rest. The last step's accelerations predict the motion at the middle of the step. There
// the contact-free accelerations, the rows' matrix and the contact forces are computed. The forces
// are such that the rows' rates at the step's END obey their laws; motors respond to the joints'
// rates at the middle. These accelerations a are constant over the step:
//     v1 = v0 + h a,   q1 = q0 + h (v0 + v1) / 2.
// It is of second order with two evaluations. The evaluation at the end is free of contact and is
// the first one of the next step. (E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary
// Differential Equations I, II.1.)

#include "planar/constraints/contact_solver.h"
#include "planar/evaluation/cache_numbers.h"
#include "planar/stepping/integrator.h"

namespace cambrian {

struct MidpointRequest {
    const StepRequest& step;          // its start_rate is free of contact
    const EvaluationCache& start;     // at the step's start, with everything
    const PerCoordinate& prediction;  // accelerations of the first half, m/s^2 or rad/s^2
};

class MidpointStep {
public:
    static constexpr int kErrorOrder = 3;

    // Attempts one step with the contacts and stops that were selected at its start. The system's
    // forcing must not have contact forces. Afterwards `cache` is that of the step's end, free of
    // contact. Returns false if the solver used a fallback.
    bool attempt(const MotionSystem& system, const ContactLaw& law, const MidpointRequest& request,
                 ContactSolver& contacts, WarmStart& warm, EvaluationCache& cache,
                 StepResult& result);

    // Sets what an earlier model used beyond the counts to 0.
    void clear_beyond(const ChangedCounts& counts);

    // Returns accelerations and mean powers of the step attempted last.
    const MotionRate& mean_rate() const { return mean_rate_; }

private:
    void respond(const PlanarModel& model, const ContactSolver& contacts, double h);
    void respond_to_nothing(const PlanarModel& model);
    void integrate_works(const PlanarModel& model, const MidpointRequest& request,
                         const EvaluationCache& cache, StepResult& result);
    double estimate_error(const PlanarModel& model, const ContactLaw& law, const StepRequest& step,
                          ContactSolver& contacts, const StepResult& result) const;
    void take_damping(const PlanarModel& model, const PerCoordinate (&changes)[2],
                      PerCoordinate (&errors)[2]) const;
    void damp(const PlanarModel& model, const PerCoordinate& change, const double* spin,
              PerBody& efforts) const;
    bool take_absorbed(const PlanarModel& model, const ContactLaw& law, ContactSolver& contacts,
                       PerCoordinate (&errors)[2]) const;
    void add_responses(const PlanarModel& model, const Loads (&loads)[2],
                       PerCoordinate (&errors)[2]) const;

    Motion predicted_ = {};
    EvaluationCache middle_ = {};
    MotionRate middle_rate_ = {};  // free of contact
    BodyResponse held_ = {};
    MotionRate mean_rate_ = {};
};

}  // namespace cambrian
