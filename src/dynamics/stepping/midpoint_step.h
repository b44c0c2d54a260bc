#pragma once

// One step under contact forces by the midpoint rule, implicit for the motors' damping and explicit
// for the rest. The motion is predicted to the middle of the step with the last step's
// accelerations; there the contact-free accelerations, the rows' matrix and the contact forces are
// found, the forces such that the rows' rates at the step's END obey their laws, and motors answer
// the joints' rates as they are in the middle. These accelerations a hold for all of the
// step:
//     v1 = v0 + h a,   q1 = q0 + h (v0 + v1) / 2.
// Second order, with two evaluations; the one at the end is free of contact and the next step's
// start. (E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.1.)

#include "dynamics/constraints/contact_solver.h"
#include "dynamics/stepping/integrator.h"

namespace cambrian {

struct MidpointRequest {
    const StepRequest& step;          // its start_rate is free of contact
    const EvaluationCache& start;     // at the step's start, with everything
    const PerCoordinate& prediction;  // accelerations of the first half, m/s^2 or rad/s^2
};

class MidpointStep {
public:
    static constexpr int kErrorOrder = 3;

    // One attempt with the contacts and stops chosen at the start; the system's forcing must hold
    // nothing. cache is left at the step's end, free of contact. Returns false if the solver used a
    // fallback.
    bool attempt(const MotionSystem& system, const ContactLaw& law, const MidpointRequest& request,
                 ContactSolver& contacts, WarmStart& warm, EvaluationCache& cache,
                 StepResult& result);

    // Accelerations and mean powers over the step last attempted.
    const MotionRate& mean_rate() const { return mean_rate_; }

private:
    void respond(const PlanarModel& model, const ContactSolver& contacts, double h);
    void integrate_works(const PlanarModel& model, const MidpointRequest& request,
                         const EvaluationCache& cache, StepResult& result);
    double estimate_error(const PlanarModel& model, const ContactLaw& law, const StepRequest& step,
                          ContactSolver& contacts, const StepResult& result) const;
    void take_damping(const PlanarModel& model, const PerCoordinate (&changes)[2],
                      PerCoordinate (&errors)[2]) const;
    void damp(const PlanarModel& model, const PerCoordinate& change, const double* spin,
              PerBody& efforts) const;
    void take_absorbed(const PlanarModel& model, const ContactLaw& law, ContactSolver& contacts,
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
