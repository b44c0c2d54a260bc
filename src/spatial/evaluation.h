#pragma once

// The motion's differential equation during one tick.

#include "spatial/forces.h"

#include <memory>

namespace cambrian::spatial {

// All that is computed at one state.
struct Evaluation {
    Kinematics kinematics;
    Loads loads;
    Factors factors;
    Response response;
};

// An evaluation on the heap, so that two of them are exchanged without copying numbers.
class OwnedEvaluation {
public:
    OwnedEvaluation() : evaluation_(std::make_unique<Evaluation>()) {}
    OwnedEvaluation(const OwnedEvaluation& other)
        : evaluation_(std::make_unique<Evaluation>(*other.evaluation_)) {}
    OwnedEvaluation& operator=(const OwnedEvaluation& other) {
        *evaluation_ = *other.evaluation_;
        return *this;
    }
    Evaluation& operator*() { return *evaluation_; }
    const Evaluation& operator*() const { return *evaluation_; }
    Evaluation* operator->() { return evaluation_.get(); }
    const Evaluation* operator->() const { return evaluation_.get(); }
    void swap(OwnedEvaluation& other) { evaluation_.swap(other.evaluation_); }

private:
    std::unique_ptr<Evaluation> evaluation_;
};

// A stage in the middle of a step whose motors are implicit (forces.h).
struct ImplicitStage {
    const Motion& start;
    double time = 0.0;  // s since the step's start
};

// Computes the rates under motors, drag, gravity and pulls. `share` is that of the tick.
void evaluate(const Model& model, const Forcing& forcing, const Motion& motion, double share,
              Evaluation& evaluation, MotionRate& rate, const ImplicitStage* implicit = nullptr);

// Kinetic and potential energy, J; the potential is 0 at the origin.
double mechanical_energy(const Model& model, const Medium& medium, const Motion& motion,
                         const Kinematics& kinematics);

}  // namespace cambrian::spatial
