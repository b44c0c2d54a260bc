#include "math/elementary.h"
#include "planar/evaluation/accelerations.h"
#include "planar/forces/drag.h"
#include "planar/forces/motors.h"
#include "planar/model/dense_lanes.h"

namespace cambrian {
namespace {

template <int kBlocks, Motors kMotors>
class DenseEvaluation {
public:
    CAMBRIAN_INLINE DenseEvaluation(const PlanarModel& model, const Forcing& forcing,
                                    const Motion& motion, EvaluationCache& cache, MotionRate& rate)
        : model_(model),
          form_(model.dense),
          forcing_(forcing),
          motion_(motion),
          cache_(cache),
          rate_(rate),
          bodies_(model.body_count) {}

    CAMBRIAN_INLINE void run(const EvaluationPoint& point) {
        const bool all = point.detail == EvaluationDetail::kEverything;
        turn_bodies();
        drive_joints(point);
        const Medium& medium = forcing_.medium;
        const bool is_dragged = medium.drag_linear > 0.0 || medium.drag_quadratic > 0.0;
        if (all || is_dragged) move_bodies();
        rate_.power[kDragWork] = is_dragged ? drag_bodies() : 0.0;
        rate_.power[kSpinGiven] = is_dragged ? whole_torque() : 0.0;
        rate_.power[kPullWork] = 0.0;
        couple_angles();
        if constexpr (kMotors == Motors::kImplicit)
            invert();
        else
            eliminate();
        keep_accelerations(all || kMotors == Motors::kImplicit);
        cache_.has_centers = false;
        cache_.has_joint_geometry = false;
        cache_.is_factored = false;
        cache_.is_inverted = kMotors == Motors::kImplicit;
    }

private:
    static constexpr int kLines = kBlocks * kLanes;
    static constexpr std::size_t kSlots = kLines;

    // Padding does not move.
    CAMBRIAN_INLINE void turn_bodies() {
        Kinematics& k = cache_.kinematics;
        for (int i = 0; i < kLines; i += kLanes) {
            const Simd4d member = load_lanes(model_.members_of(0).membership + i);
            store_lanes(k.angle + i, member * load_lanes(motion_.position + i));
            store_lanes(k.spin + i, member * load_lanes(motion_.speed + i));
        }
        for (int i = 0; i < kLines; i += kLanes) {
            for (int lane = i; lane < i + kLanes; ++lane) {
                const SineCosine turn = sine_cosine_reduced(k.angle[lane]);
                k.sine[lane] = turn.sine;
                k.cosine[lane] = turn.cosine;
            }
        }
        sine_.load(k.sine);
        cosine_.load(k.cosine);
    }

    // Adds the efforts of motors, which act on a body and back on its parent.
    CAMBRIAN_INLINE void drive_joints(const EvaluationPoint& point) {
        Kinematics& k = cache_.kinematics;
        double torque[kSlots];
        Simd4d net = {};
        Simd4d gross = {};
        for (int i = 0; i < kLines; i += kLanes) {
            const int* parents = model_.parent_slot + i;
            const Simd4d position = load_lanes(k.angle + i) - gather(k.angle, parents) -
                                    load_lanes(model_.rest_angle + i);
            const Simd4d rate = load_lanes(k.spin + i) - gather(k.spin, parents);
            store_lanes(k.joint_position + i, position);
            store_lanes(k.joint_rate + i, rate);
            Simd4d effort;
            if constexpr (kMotors == Motors::kImplicit) {
                const ImplicitEfforts motors = implicit_efforts(
                    model_, forcing_.drive, point.tick_share, *point.implicit, position, rate, i);
                effort = motors.effort;
                store_lanes(cache_.motor_damping + i, motors.damping);
            } else {
                effort = motor_efforts(model_, forcing_.drive, point.tick_share, position, rate, i);
                const Simd4d power = effort * rate;
                net += power;
                gross += magnitude(power);
            }
            store_lanes(cache_.motor_effort + i, effort);
            store_lanes(torque + i, effort);
        }
        rate_.power[kMotorWork] = sum_of(net);
        rate_.power[kGrossMotorWork] = sum_of(gross);
        for (int i = 1; i < bodies_; ++i)
            torque[model_.parent[i]] -= cache_.motor_effort[i];
        torque_.load(torque);
    }

    // Computes positions and velocities of the centres.
    CAMBRIAN_INLINE void move_bodies() {
        Kinematics& k = cache_.kinematics;
        BodyLanes<kBlocks> x;
        BodyLanes<kBlocks> y;
        BodyLanes<kBlocks> velocity_x;
        BodyLanes<kBlocks> velocity_y;
        for (int b = 0; b < kBlocks; ++b) {
            x[b] = all_lanes(motion_.position[bodies_]);
            y[b] = all_lanes(motion_.position[bodies_ + 1]);
            velocity_x[b] = all_lanes(motion_.speed[bodies_]);
            velocity_y[b] = all_lanes(motion_.speed[bodies_ + 1]);
        }
        for (int angle = 0; angle < bodies_; ++angle) {
            const Simd4d cosine = all_lanes(k.cosine[angle]);
            const Simd4d sine = all_lanes(k.sine[angle]);
            const Simd4d spin = all_lanes(k.spin[angle]);
            for (int b = 0; b < kBlocks; ++b) {
                const Simd4d d_x = load_lanes(form_.arm_x + angle * kLines + b * kLanes);
                const Simd4d d_y = load_lanes(form_.arm_y + angle * kLines + b * kLanes);
                const Simd4d arm_x = cosine * d_x - sine * d_y;
                const Simd4d arm_y = sine * d_x + cosine * d_y;
                x[b] += arm_x;
                y[b] += arm_y;
                velocity_x[b] -= spin * arm_y;
                velocity_y[b] += spin * arm_x;
            }
        }
        for (int b = 0; b < kBlocks; ++b) {
            const Simd4d member = load_lanes(model_.members_of(0).membership + b * kLanes);
            store_lanes(k.x + b * kLanes, member * x[b]);
            store_lanes(k.y + b * kLanes, member * y[b]);
            store_lanes(k.velocity_x + b * kLanes, member * velocity_x[b]);
            store_lanes(k.velocity_y + b * kLanes, member * velocity_y[b]);
        }
    }

    // Adds forces and torques of the medium on the bodies; returns their power.
    CAMBRIAN_INLINE double drag_single_boxes(Loads& loads) {
        const Kinematics& k = cache_.kinematics;
        Simd4d power = {};
        for (int i = 0; i < kLines; i += kLanes) {
            const BoxDrag drag = drag_boxes(
                forcing_.medium, {{load_lanes(k.cosine + i), load_lanes(k.sine + i)},
                                  {load_lanes(k.velocity_x + i), load_lanes(k.velocity_y + i)},
                                  load_lanes(k.spin + i),
                                  load_lanes(model_.box_half_length + i),
                                  load_lanes(model_.box_half_width + i)});
            store_lanes(loads.force_x + i, drag.force_x);
            store_lanes(loads.force_y + i, drag.force_y);
            torque_[i / kLanes] += drag.moment;
            power += drag.power;
        }
        return sum_of(power);
    }
    CAMBRIAN_INLINE double drag_welded_boxes(Loads& loads) {
        clear_loads(model_, loads);
        const double power = add_drag(model_, forcing_.medium, cache_.kinematics, loads);
        for (int b = 0; b < kBlocks; ++b)
            torque_[b] += load_lanes(loads.torque + b * kLanes);
        return power;
    }

    // Adds the generalised force of a force on a body to all angles.
    CAMBRIAN_INLINE double drag_bodies() {
        Loads& loads = cache_.loads;
        const double power =
            has_single_boxes(model_) ? drag_single_boxes(loads) : drag_welded_boxes(loads);
        Levers<kBlocks> levers(form_, cache_.kinematics);
        for (int body = 0; body < bodies_; ++body) {
            drag_x_ += loads.force_x[body];
            drag_y_ += loads.force_y[body];
            levers.add_force(body, loads.force_x[body], loads.force_y[body]);
        }
        for (int b = 0; b < kBlocks; ++b)
            torque_[b] += levers.torque(b);
        return power;
    }

    // The sum of the generalised forces of all angles, in which the efforts of motors cancel.
    CAMBRIAN_INLINE double whole_torque() const {
        Simd4d sum = torque_[0];
        for (int b = 1; b < kBlocks; ++b)
            sum += torque_[b];
        return sum_of(sum);
    }

    // Fills the mass matrix and the velocity terms.
    CAMBRIAN_INLINE void couple_angles() {
        const Kinematics& k = cache_.kinematics;
        const int columns = kBlocks == 1 ? kLanes : bodies_;
        for (int j = 0; j < columns; ++j) {
            const Simd4d cosine = all_lanes(k.cosine[j]);
            const Simd4d sine = all_lanes(k.sine[j]);
            const Simd4d square = all_lanes(k.spin[j] * k.spin[j]);
            for (int b = 0; b < kBlocks; ++b) {
                const Simd4d a = load_lanes(form_.inertia_cosine + j * kLines + b * kLanes);
                const Simd4d s = load_lanes(form_.inertia_sine + j * kLines + b * kLanes);
                const Simd4d along = a * cosine_[b] + s * sine_[b];
                const Simd4d across = a * sine_[b] - s * cosine_[b];
                column_[j][b] = along * cosine + across * sine;
                torque_[b] += (along * sine - across * cosine) * square;
            }
        }
    }

    // Solves by Gauss-Jordan elimination; the matrix is positive definite.
    CAMBRIAN_INLINE void eliminate() {
        const int columns = kBlocks == 1 ? kLanes : bodies_;
        BodyLanes<kBlocks> inverse_pivot = {};
        for (int k = 0; k < columns; ++k) {
            const double inverse = 1.0 / column_[k].at(k);
            inverse_pivot.put_at(k, inverse);
            BodyLanes<kBlocks> factor;
            for (int b = 0; b < kBlocks; ++b)
                factor[b] = column_[k][b] * inverse;
            factor.put_at(k, 0.0);
            for (int j = k + 1; j < columns; ++j) {
                const Simd4d pivot_row = all_lanes(column_[j].at(k));
                for (int b = 0; b < kBlocks; ++b)
                    column_[j][b] -= factor[b] * pivot_row;
            }
            const Simd4d pivot_row = all_lanes(torque_.at(k));
            for (int b = 0; b < kBlocks; ++b)
                torque_[b] -= factor[b] * pivot_row;
        }
        for (int b = 0; b < kBlocks; ++b)
            torque_[b] *= inverse_pivot[b];
        keep_turn(torque_);
    }

    // Inverts the matrix in place, with the damping of implicit motors, for later loads.
    CAMBRIAN_INLINE void invert() {
        for (int i = 1; i < bodies_; ++i) {
            const int p = model_.parent[i];
            const double damping = cache_.motor_damping[i];
            column_[i].add_at(i, damping);
            column_[p].add_at(p, damping);
            column_[i].add_at(p, -damping);
            column_[p].add_at(i, -damping);
        }
        const int columns = kBlocks == 1 ? kLanes : bodies_;
        for (int k = 0; k < columns; ++k) {
            const double inverse = 1.0 / column_[k].at(k);
            const BodyLanes<kBlocks> pivot_column = column_[k];
            for (int j = 0; j < columns; ++j) {
                if (j == k) continue;
                const double scaled = column_[j].at(k) * inverse;
                for (int b = 0; b < kBlocks; ++b)
                    column_[j][b] -= pivot_column[b] * scaled;
                column_[j][k / kLanes][k % kLanes] = scaled;
            }
            for (int b = 0; b < kBlocks; ++b)
                column_[k][b] *= -inverse;
            column_[k][k / kLanes][k % kLanes] = inverse;
        }
        for (int k = 0; k < columns; ++k)
            column_[k].store(cache_.inverse + k * kLines);
        keep_turn(times_inverse(cache_.inverse, bodies_, torque_));
    }

    CAMBRIAN_INLINE void keep_turn(const BodyLanes<kBlocks>& turn) {
        turn_ = turn;
        turn_.store(cache_.response.spin);
    }

    // Stores the accelerations of all coordinates, on demand in the response, too.
    CAMBRIAN_INLINE void keep_accelerations(bool with_response) {
        const double share = 1.0 / model_.total_mass;
        const double x = forcing_.medium.gravity_x + share * drag_x_;
        const double y = forcing_.medium.gravity_y + share * drag_y_;
        store_coordinates(turn_, bodies_, x, y, rate_.acceleration);
        if (with_response) store_coordinates(turn_, bodies_, x, y, cache_.response.coordinate);
    }

    const PlanarModel& model_;
    const DenseForm& form_;
    const Forcing& forcing_;
    const Motion& motion_;
    EvaluationCache& cache_;
    MotionRate& rate_;
    const int bodies_;
    BodyLanes<kBlocks> sine_, cosine_, torque_;
    BodyLanes<kBlocks> turn_;  // angular accelerations, rad/s^2
    BodyLanes<kBlocks> column_[kSlots];
    double drag_x_ = 0.0, drag_y_ = 0.0;
};

// These are separate functions, because in one function the compiler unrolls neither.
template <int kBlocks, Motors kMotors>
[[gnu::noinline]] void evaluate(const PlanarModel& model, const Forcing& forcing,
                                const Motion& motion, const EvaluationPoint& point,
                                EvaluationCache& cache, MotionRate& rate) {
    DenseEvaluation<kBlocks, kMotors>(model, forcing, motion, cache, rate).run(point);
}

}  // namespace

void evaluate_dense(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                    const EvaluationPoint& point, EvaluationCache& cache, MotionRate& rate) {
    static_assert(kMaxDenseBlocks == 2);
    const bool small = model.dense.blocks == 1;
    if (point.implicit == nullptr)
        (small ? evaluate<1, Motors::kExplicit>
               : evaluate<2, Motors::kExplicit>)(model, forcing, motion, point, cache, rate);
    else
        (small ? evaluate<1, Motors::kImplicit>
               : evaluate<2, Motors::kImplicit>)(model, forcing, motion, point, cache, rate);
}

}  // namespace cambrian
