#pragma once

// Stops of the joints as rows: one at each end of a hinge or a slide; of a ball one at its cone and
// two of its twist.

#include "spatial/articulated_body.h"

#include <vector>

namespace cambrian::spatial {

// A degree, or an angle of a ball, near one of its stops.
struct Stop {
    enum class Kind : unsigned char { kDegree, kSwing, kTwist };

    int degree = 0;     // the first of a ball
    double sign = 1.0;  // +1 at the low stop, -1 at the high one
    double gap = 0.0;   // rad or m
    double rate = 0.0;  // opening is positive
    Kind kind = Kind::kDegree;
    double share[3] = {sign, 0.0, 0.0};  // of the degrees' rates in that of the stop
    double bias = 0.0;                   // rad/s^2; what its rate changes without accelerations

    int degree_count() const { return kind == Kind::kDegree ? 1 : 3; }
    bool moves(int d) const { return d >= degree && d < degree + degree_count(); }
    // Returns the row's sum of the degrees' numbers.
    double sum(const double* degrees) const {
        double sum = share[0] * degrees[degree];
        for (int d = 1; d < degree_count(); ++d)
            sum += share[d] * degrees[degree + d];
        return sum;
    }
    void add_effort(double impulse, Push& push) const {
        for (int d = 0; d < degree_count(); ++d)
            push.effort[degree + d] += share[d] * impulse;
    }
};

// Returns how many stops a motion can meet at once, at most.
inline std::size_t most_stops(const Model& model) {
    return 2 * static_cast<std::size_t>(model.degree_count);
}

// Finds the stops that may matter in a step of this length (s).
void find_stops(const Model& model, const Motion& motion, double length, std::vector<Stop>& stops);
// Sets the shares and biases of balls, which turn with them, to those of a moment.
void turn_stops(const Model& model, const Kinematics& kinematics, std::vector<Stop>& stops);

// Returns how far the worst joint is beyond a stop, rad or m.
double limit_overrun(const Model& model, const Motion& motion);
// The same of balls beyond their cones, rad.
double swing_overrun(const Model& model, const Motion& motion);

}  // namespace cambrian::spatial
