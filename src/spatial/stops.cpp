#include "spatial/stops.h"

#include <algorithm>

namespace cambrian::spatial {
namespace {

constexpr double kStopReach = 1e-3;      // rad or m; of stops that count as touched
constexpr double kStopReachSteps = 1.5;  // steps in which a closing stop may close

// The shares of its rows follow from the directions later.
template <class Take>
void visit_ball_stops(const Model& model, const Motion& motion, int b, Take& take) {
    const int first = model.bodies[b].first_degree;
    const Degree& twist = model.degrees[first + 2];
    const Rotation attitude = ball_attitude(model, motion, b);
    const Vec3 spin = ball_spin(model, motion, b);
    const BallAngles angles = ball_angles(attitude);
    const BallDirections directions = ball_directions({}, turn_of(attitude), spin);
    const double turning = dot(directions.twist, spin);
    take(Stop{first, -1.0, model.degrees[first].high - angles.swing(), -dot(directions.swing, spin),
              Stop::Kind::kSwing});
    take(Stop{first, 1.0, angles.twist - twist.low, turning, Stop::Kind::kTwist});
    take(Stop{first, -1.0, twist.high - angles.twist, -turning, Stop::Kind::kTwist});
}

template <class Take>
void visit_stops(const Model& model, const Motion& motion, Take&& take) {
    for (int d = 0; d < model.degree_count; ++d) {
        const Degree& degree = model.degrees[d];
        if (model.bodies[degree.body].is_ball) continue;
        const double position = motion.position[d];
        const double rate = motion.speed[d];
        take(Stop{d, 1.0, position - degree.low, rate});
        take(Stop{d, -1.0, degree.high - position, -rate});
    }
    for (int i = 0; i < model.ball_count; ++i)
        visit_ball_stops(model, motion, model.balls[i], take);
}

}  // namespace

void find_stops(const Model& model, const Motion& motion, double length, std::vector<Stop>& stops) {
    stops.clear();
    visit_stops(model, motion, [&stops, length](const Stop& stop) {
        if (stop.gap < kStopReachSteps * length * std::max(0.0, -stop.rate) + kStopReach)
            stops.push_back(stop);
    });
}

void turn_stops(const Model& model, const Kinematics& k, std::vector<Stop>& stops) {
    for (Stop& stop : stops) {
        if (stop.kind == Stop::Kind::kDegree) continue;
        const int b = model.degrees[stop.degree].body;
        const int parent = model.bodies[b].parent;
        const BallDirections directions = ball_directions(
            k.turn[parent] * model.bodies[b].joint_frame, k.turn[b], k.spin[b] - k.spin[parent]);
        const bool swings = stop.kind == Stop::Kind::kSwing;
        const Vec3& along = swings ? directions.swing : directions.twist;
        for (int d = 0; d < 3; ++d)
            stop.share[d] = stop.sign * dot(k.axis[stop.degree + d].angular, along);
        stop.bias = stop.sign * (swings ? directions.swing_bias : directions.twist_bias);
    }
}

double limit_overrun(const Model& model, const Motion& motion) {
    double most = 0.0;
    visit_stops(model, motion, [&most](const Stop& stop) { most = std::max(most, -stop.gap); });
    return most;
}

double swing_overrun(const Model& model, const Motion& motion) {
    double most = 0.0;
    for (int i = 0; i < model.ball_count; ++i) {
        const int b = model.balls[i];
        const double swing = ball_angles(ball_attitude(model, motion, b)).swing();
        most = std::max(most, swing - model.degrees[model.bodies[b].first_degree].high);
    }
    return most;
}

}  // namespace cambrian::spatial
