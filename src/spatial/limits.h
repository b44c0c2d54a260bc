#pragma once

// Stops of the joints as rows: rates u+ = u- + W p with impulses p >= 0, u+ >= 0 and p u+ = 0
// (planar/README.md 9 to 12). Without friction W is positive definite, so there is always one
// solution.

#include "spatial/evaluation.h"

namespace cambrian::spatial {

inline constexpr int kMostRows = kMostJointDegrees;

// A degree near one of its stops.
struct LimitRow {
    int degree = 0;
    double sign = 1.0;  // +1 at the low stop, -1 at the high one
    double gap = 0.0;   // rad or m
    double rate = 0.0;  // at the step's start; opening is positive
};

class LimitRows {
public:
    // Selects the stops within reach of a step of this length. Returns whether there are any.
    bool select(const Model& model, const Motion& motion, double length);
    // Selects those that are touched.
    bool select_touched(const Model& model, const Motion& motion);
    void clear() { count_ = 0; }

    // Computes the impulses of a step of this length whose free accelerations and factors are those
    // of the evaluation. Returns false if the states of the rows did not settle.
    bool solve_step(const Model& model, const Evaluation& evaluation, double length);
    // Computes the impulses that stop what closes.
    bool solve_impact(const Model& model, const Evaluation& evaluation);

    // Returns whether any impulse is above 0.
    bool holds_something() const;
    // Adds the impulses, times a scale, to the efforts of the degrees.
    void add_efforts(double scale, double* efforts) const;
    // Sets efforts that undo these changes of the degrees' rates at the rows with impulses. Returns
    // false if there are none.
    bool absorb(const double* changes, double* efforts);

    int count() const { return count_; }
    const LimitRow& row(int index) const { return rows_[index]; }
    double impulse(int index) const { return impulse_[index]; }
    // Changes of a row's rate by the impulses.
    double effect(int index) const;

private:
    void add(const LimitRow& row);
    void build(const Model& model, const Evaluation& evaluation);
    bool solve();
    bool settle(bool (&active)[kMostRows]);
    bool solve_active(const bool (&active)[kMostRows], const double* right, double* solution);

    int count_ = 0;
    LimitRow rows_[kMostRows];
    double bias_[kMostRows] = {};
    double impulse_[kMostRows] = {};
    double matrix_[kMostRows][kMostRows] = {};
    double factor_[kMostRows][kMostRows] = {};
    double regularization_[kMostRows] = {};
    bool active_[kMostRows] = {};
};

// Returns how far the worst joint is beyond a stop, rad or m.
double limit_overrun(const Model& model, const Motion& motion);

}  // namespace cambrian::spatial
