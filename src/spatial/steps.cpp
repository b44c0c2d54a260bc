#include "spatial/steps.h"

#include "core/assert.h"
#include "dynamics/tableaus.h"

#include <algorithm>
#include <cmath>

namespace cambrian::spatial {
namespace {

// The sum of squared errors of position / (0.1 m or rad) and of speed / (1 + |speed|).
class ErrorSum {
public:
    void add(double position, double speed, double present_speed) {
        const double p = step_policy::kPerPosition * position;
        const double v = speed / (1.0 + std::fabs(present_speed));
        sum_ += p * p + v * v;
    }
    // Vectors count by their lengths, so that the steps do not depend on how a body is turned.
    void add(const Vec3& position, const Vec3& speed, const Vec3& present_speed) {
        const double size = 1.0 + std::sqrt(dot(present_speed, present_speed));
        sum_ += step_policy::kPerPosition * step_policy::kPerPosition * dot(position, position) +
                dot(speed, speed) / (size * size);
    }
    double rms(int coordinates) const { return std::sqrt(sum_ / (2.0 * coordinates)); }

private:
    double sum_ = 0.0;
};

template <class Tableau>
class EmbeddedStep {
public:
    EmbeddedStep(const MotionSystem& system, const StepRequest& request, Evaluation& end,
                 StepResult& result)
        : system_(system),
          request_(request),
          evaluation_(end),
          result_(result),
          count_(system.model.coordinate_count()) {
        rates_[0] = request.start_rate;
    }

    void attempt() {
        Motion& motion = result_.end;
        copy_attitudes(system_.model, request_.start, motion);
        for (std::size_t stage = 1; stage <= kLast; ++stage) {
            for (int c = 0; c < count_; ++c) {
                motion.position[c] =
                    request_.start.position[c] + sum(&MotionRate::position, c, stage);
                motion.speed[c] = request_.start.speed[c] + sum(&MotionRate::speed, c, stage);
            }
            system_.evaluate(motion, request_.time + Tableau::kNodes[stage] * request_.length,
                             evaluation_, rates_[stage]);
        }
        for (int w = 0; w < kWorkCount; ++w) {
            double given = 0.0;
            for (std::size_t j = 0; j < kLast; ++j)
                given += Tableau::kRows[kLast][j] * rates_[j].power[w];
            motion.work[w] = request_.start.work[w] + request_.length * given;
        }
        result_.end_rate = rates_[kLast];
        result_.error = error();
        result_.evaluations = static_cast<int>(kLast);
    }

private:
    static constexpr std::size_t kLast = Tableau::kStages - 1;
    using Rates = double (MotionRate::*)[kMostCoordinates];

    // The length times the stage's weighted sum of the rates before it.
    double sum(Rates rates, int c, std::size_t stage) const {
        double total = 0.0;
        for (std::size_t j = 0; j < stage; ++j)
            total += Tableau::kRows[stage][j] * (rates_[j].*rates)[c];
        return request_.length * total;
    }
    double difference(Rates rates, int c) const {
        double total = 0.0;
        for (std::size_t j = 0; j <= kLast; ++j)
            total += Tableau::kErrors[j] * (rates_[j].*rates)[c];
        return request_.length * total;
    }
    Vec3 difference_vector(Rates rates, int c) const {
        return {difference(rates, c), difference(rates, c + 1), difference(rates, c + 2)};
    }

    // The error of the angular momentum counts as that of the root's angular velocity.
    double error() const {
        const Model& model = system_.model;
        const Motion& end = result_.end;
        const Kinematics& k = evaluation_.kinematics;
        const int attitude = model.attitude();
        const int place = model.place();
        ErrorSum errors;
        for (int d = 0; d < model.degree_count; ++d)
            errors.add(difference(&MotionRate::position, d), difference(&MotionRate::speed, d),
                       end.speed[d]);
        const Vec3 turn = difference_vector(&MotionRate::position, attitude);
        const Vec3 momentum = difference_vector(&MotionRate::speed, attitude);
        const Vec3 spin = cross(turn, k.spin[0]) +
                          solved(k.whole_inertia,
                                 momentum - cross(turn, coordinate_vector(end.speed + attitude)));
        errors.add(turn, spin, k.spin[0]);
        errors.add(difference_vector(&MotionRate::position, place),
                   difference_vector(&MotionRate::speed, place),
                   coordinate_vector(end.speed + place));
        return errors.rms(count_) / request_.tolerance;
    }

    const MotionSystem& system_;
    const StepRequest& request_;
    Evaluation& evaluation_;
    StepResult& result_;
    int count_;
    MotionRate rates_[Tableau::kStages];
};

template <class Tableau>
void attempt_embedded(const MotionSystem& system, const StepRequest& request, Evaluation& end,
                      StepResult& result) {
    EmbeddedStep<Tableau>(system, request, end, result).attempt();
}

const Integrator kIntegrators[] = {
    {"bogacki-shampine", "Bogacki-Shampine", attempt_embedded<tableau::BogackiShampine>, 3},
    {"dormand-prince", "Dormand-Prince", attempt_embedded<tableau::DormandPrince>, 5}};

// Moves for a time under constant accelerations. Charts start at 0.
void accelerate(const Model& model, const Motion& start, const Vec3& root_spin, double time,
                const MotionRate& rate, Motion& end) {
    copy_attitudes(model, start, end);
    for (int c = 0; c < model.coordinate_count(); ++c) {
        const double change = time * rate.speed[c];
        end.speed[c] = start.speed[c] + change;
        end.position[c] = start.position[c] + time * (start.speed[c] + 0.5 * change);
    }
    set_coordinate_vector(end.position + model.attitude(),
                          time * (root_spin + (0.5 * time) * rate.root_turning));
}

// Adds what the damping of implicit motors makes of a change of speeds.
void damp(const Model& model, const Evaluation& middle, const Change& change, Change& error) {
    Push push;
    for (int d = 0; d < model.degree_count; ++d)
        push.effort[d] = -middle.loads.damping[d] * change.joint[d];
    Response response;
    respond(model, middle.kinematics, middle.factors, push, response);
    error.add(model, response, push);
}

}  // namespace

std::span<const Integrator> integrators() {
    return kIntegrators;
}

bool MidpointStep::attempt(const MotionSystem& system, const StepRequest& request,
                           const MotionRate& prediction, Rows& rows, Evaluation& end,
                           StepResult& result) {
    const Model& model = system.model;
    const Forcing& forcing = system.forcing;
    const double h = request.length;
    // The chart starts at 0, so its rate is the root's spin.
    const Vec3 spin = coordinate_vector(request.start_rate.position + model.attitude());
    accelerate(model, request.start, spin, 0.5 * h, prediction, predicted_);
    const ImplicitStage stage{request.start, 0.5 * h};
    system.evaluate(predicted_, request.time + 0.5 * h, middle_, middle_rate_, &stage);
    const bool settled =
        rows.solve_step(model, forcing.medium.gravity, forcing.ground.friction, middle_, h);
    mean_ = middle_rate_;
    if (rows.holds_something()) {
        Push push;
        rows.add_push(1.0 / h, push);
        Response response;
        respond(model, middle_.kinematics, middle_.factors, push, response);
        add_push(model, push, response, mean_.speed);
        mean_.root_turning += response.root_turning();
    }
    accelerate(model, request.start, spin, h, mean_, result.end);
    system.evaluate(result.end, request.time + h, end, result.end_rate);
    integrate_works(model, request, result);
    result.error = estimate_error(model, request, rows, result);
    result.evaluations = 2;
    return settled;
}

// Efforts of motors are constant, so their works are exact; those of drag and pull follow Simpson's
// rule.
void MidpointStep::integrate_works(const Model& model, const StepRequest& request,
                                   StepResult& result) const {
    double net = 0.0;
    double gross = 0.0;
    for (int d = 0; d < model.degree_count; ++d) {
        const double work = effort(d) * (result.end.position[d] - request.start.position[d]);
        net += work;
        gross += std::fabs(work);
    }
    const double* before = request.start.work;
    result.end.work[kMotorWork] = before[kMotorWork] + net;
    result.end.work[kGrossMotorWork] = before[kGrossMotorWork] + gross;
    for (const Work w : {kDragWork, kPullWork})
        result.end.work[w] =
            before[w] + request.length / 6.0 *
                            (request.start_rate.power[w] + 4.0 * middle_rate_.power[w] +
                             result.end_rate.power[w]);
}

void MidpointStep::rates_at_ends(const Model& model, const StepRequest& request,
                                 const StepResult& result, MotionRate& start,
                                 MotionRate& end) const {
    start = request.start_rate;
    end = result.end_rate;
    const auto give_powers = [&](const Motion& motion, MotionRate& rate) {
        double net = 0.0;
        double gross = 0.0;
        for (int d = 0; d < model.degree_count; ++d) {
            const double power = effort(d) * motion.speed[d];
            net += power;
            gross += std::fabs(power);
        }
        rate.power[kMotorWork] = net;
        rate.power[kGrossMotorWork] = gross;
    };
    give_powers(request.start, start);
    give_powers(result.end, end);
    for (MotionRate* rate : {&start, &end})
        std::copy_n(mean_.speed, model.coordinate_count(), rate->speed);
}

double MidpointStep::estimate_error(const Model& model, const StepRequest& request, Rows& rows,
                                    const StepResult& result) const {
    const double h = request.length;
    const MotionRate& start = request.start_rate;
    const MotionRate& end = result.end_rate;
    const int place = model.place();
    Change speed;
    Change position;
    Change damped;
    for (int d = 0; d < model.degree_count; ++d) {
        const double both = start.speed[d] + end.speed[d];
        speed.joint[d] = h / 6.0 * (both - 2.0 * middle_rate_.speed[d]);
        damped.joint[d] = h / 6.0 * (both - 2.0 * mean_.speed[d]);
        position.joint[d] = h * h / 12.0 * (end.speed[d] - start.speed[d]);
    }
    speed.root =
        h / 6.0 * (start.root_turning + end.root_turning - 2.0 * middle_rate_.root_turning);
    position.root = h * h / 12.0 * (end.root_turning - start.root_turning);
    const Vec3 first = coordinate_vector(start.speed + place);
    const Vec3 last = coordinate_vector(end.speed + place);
    speed.center = h / 6.0 * (first + last - 2.0 * coordinate_vector(middle_rate_.speed + place));
    position.center = h * h / 12.0 * (last - first);
    const Change undamped = position;
    damp(model, middle_, damped, speed);
    damp(model, middle_, undamped, position);
    rows.absorb(model, middle_, speed, position);
    ErrorSum errors;
    for (int d = 0; d < model.degree_count; ++d)
        errors.add(position.joint[d], speed.joint[d], result.end.speed[d]);
    errors.add(position.root, speed.root, coordinate_vector(start.position + model.attitude()));
    errors.add(position.center, speed.center, coordinate_vector(result.end.speed + place));
    return step_policy::kCaution * errors.rms(model.coordinate_count()) / request.tolerance;
}

}  // namespace cambrian::spatial
