#pragma once

// Explicit Runge-Kutta pairs whose last stage is the step's end, so that it serves as the first
// stage of the next step. A Tableau has kStages, the kNodes c, the kRows of a (the last one holds
// the propagated weights b) and the kErrors b - b^.

#include "dynamics/integrator.h"

#include <cmath>
#include <utility>

namespace cambrian {

template <class Tableau>
class EmbeddedStep {
public:
    EmbeddedStep(const MotionSystem& system, const StepRequest& request, Frame& frame,
                 StepResult& result)
        : system_(system), request_(request), frame_(frame), result_(result) {
        speeds_[0] = request.start.speed;
        accelerations_[0] = request.start_rate.acceleration;
        powers_[0] = request.start_rate.power;
    }

    CAMBRIAN_INLINE void attempt() {
        run_stages(std::make_index_sequence<kLast>());
        constexpr auto all_stages = std::make_index_sequence<kStages>();
        const Lanes work =
            add_scaled<kLast>(load_lanes(request_.start.work), powers_, 0, all_stages);
        store_lanes(result_.end.work, work);
        result_.error = error(all_stages);
        result_.evaluations = kLast;
    }

private:
    static constexpr std::size_t kStages = Tableau::kStages;
    static constexpr std::size_t kLast = kStages - 1;
    static constexpr std::size_t kErrorRow = kStages;  // kErrors, as one more row
    static constexpr double kPerPosition = 10.0;       // 1 / (0.1 m or rad)
    static_assert(kWorkCount == kLanes);

    template <std::size_t... kBefore>
    CAMBRIAN_INLINE void run_stages(std::index_sequence<kBefore...>) {
        (run_stage<kBefore + 1>(), ...);
    }

    template <std::size_t kStage>
    CAMBRIAN_INLINE void run_stage() {
        constexpr bool is_end = kStage == kLast;
        constexpr auto earlier = std::make_index_sequence<kStage>();
        Motion& motion = is_end ? result_.end : motions_[kStage];
        MotionRate& rate = is_end ? result_.end_rate : rates_[kStage];
        const int slots = coordinate_slots(system_.model);
        for (int c = 0; c < slots; c += kLanes) {
            store_lanes(
                motion.position + c,
                add_scaled<kStage>(load_lanes(request_.start.position + c), speeds_, c, earlier));
            store_lanes(motion.speed + c, add_scaled<kStage>(load_lanes(request_.start.speed + c),
                                                             accelerations_, c, earlier));
        }
        speeds_[kStage] = motion.speed;
        accelerations_[kStage] = rate.acceleration;
        powers_[kStage] = rate.power;
        system_.evaluate(motion, request_.time + Tableau::kNodes[kStage] * request_.length,
                         is_end ? FrameDetail::kEverything : FrameDetail::kAccelerations, frame_,
                         rate);
    }

    // start + h sum of a row's weights times the stages' values, from slot c on.
    template <std::size_t kRow, std::size_t... kJ>
    CAMBRIAN_INLINE Lanes add_scaled(Lanes sum, const double* const* values, int c,
                                     std::index_sequence<kJ...>) const {
        (add_term<kRow, kJ>(sum, values[kJ] + c), ...);
        return sum;
    }
    template <std::size_t kRow, std::size_t kJ>
    CAMBRIAN_INLINE void add_term(Lanes& sum, const double* values) const {
        constexpr double weight =
            kRow == kErrorRow ? Tableau::kErrors[kJ]
            : kJ < kLast      ? Tableau::kRows[kRow < kStages ? kRow : 0][kJ < kLast ? kJ : 0]
                              : 0.0;
        if constexpr (weight != 0.0) sum += (request_.length * weight) * load_lanes(values);
    }

    // RMS over all coordinates of the errors of position / (0.1 m or rad) and of speed /
    // (1 + |speed|), in tolerances.
    template <class Stages>
    CAMBRIAN_INLINE double error(Stages stages) const {
        const int slots = coordinate_slots(system_.model);
        Lanes sum = {};
        for (int c = 0; c < slots; c += kLanes) {
            const Lanes position =
                kPerPosition * add_scaled<kErrorRow>(Lanes{}, speeds_, c, stages);
            const Lanes size = 1.0 + magnitude(load_lanes(result_.end.speed + c));
            const Lanes speed = add_scaled<kErrorRow>(Lanes{}, accelerations_, c, stages) / size;
            sum += position * position + speed * speed;
        }
        const double mean = sum_of(sum) / (2.0 * coordinate_count(system_.model));
        return std::sqrt(mean) / request_.tolerance;
    }

    const MotionSystem& system_;
    const StepRequest& request_;
    Frame& frame_;
    StepResult& result_;
    Motion motions_[kLast];  // of the inner stages; [0] is unused
    MotionRate rates_[kLast];
    const double* speeds_[kStages];
    const double* accelerations_[kStages];
    const double* powers_[kStages];
};

}  // namespace cambrian
