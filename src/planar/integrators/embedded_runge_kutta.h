#pragma once

// Embedded pairs of explicit Runge-Kutta formulas. The last stage is the step's end, so it is the
// first stage of the next step. A Tableau has kStages, the nodes c (kNodes), the rows of a (kRows;
// the last one has the propagated weights b) and kErrors, b minus b^.

#include "core/assert.h"
#include "planar/stepping/integrator.h"

#include <array>
#include <cmath>
#include <utility>

namespace cambrian {

template <class Tableau>
class EmbeddedStep {
public:
    EmbeddedStep(const MotionSystem& system, const StepRequest& request, EvaluationCache& cache,
                 StepResult& result)
        : system_(system), request_(request), cache_(cache), result_(result) {
        speeds_[0] = request.start.speed;
        accelerations_[0] = request.start_rate.acceleration;
        powers_[0] = request.start_rate.power;
    }

    CAMBRIAN_INLINE void attempt() {
        CAMBRIAN_TICK_ASSERT(request_.length > 0.0 && request_.tolerance > 0.0,
                             "a step takes time");
        run_stages(std::make_index_sequence<kLast>());
        constexpr auto all_stages = std::make_index_sequence<kStages>();
        const Sum<kLast> add_powers(request_.length, powers_);
        store_lanes(result_.end.work,
                    add_powers.add(load_lanes(request_.start.work), 0, all_stages));
        result_.end.work[kSpinGiven] =
            add_powers.add_one(request_.start.work[kSpinGiven], kSpinGiven, all_stages);
        result_.error = error(all_stages);
        result_.evaluations = kLast;
        CAMBRIAN_TICK_ASSERT(!(result_.error < 0.0), "an error is not negative");
    }

private:
    static constexpr std::size_t kStages = Tableau::kStages;
    static constexpr std::size_t kLast = kStages - 1;
    static constexpr std::size_t kErrorRow = kStages;  // kErrors, as one more row
    static constexpr double kPerPosition = 10.0;       // 1 / (0.1 m or rad)
    static_assert(kSpinGiven == kLanes && kWorkCount == kLanes + 1);
    using Values = std::array<const double*, kStages>;  // of every stage

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
        const Sum<kStage> add_speeds(request_.length, speeds_);
        const Sum<kStage> add_accelerations(request_.length, accelerations_);
        const Motion& start = request_.start;
        for (int c = 0; c < slots; c += kLanes) {
            store_lanes(motion.position + c,
                        add_speeds.add(load_lanes(start.position + c), c, earlier));
            store_lanes(motion.speed + c,
                        add_accelerations.add(load_lanes(start.speed + c), c, earlier));
        }
        speeds_[kStage] = motion.speed;
        accelerations_[kStage] = rate.acceleration;
        powers_[kStage] = rate.power;
        system_.evaluate(motion, request_.time + Tableau::kNodes[kStage] * request_.length,
                         is_end ? EvaluationDetail::kEverything : EvaluationDetail::kAccelerations,
                         cache_, rate);
    }

    // Adds h times the weighted sum of the stages' values. It copies its input, which then stays in
    // registers.
    template <std::size_t kRow>
    class Sum {
    public:
        CAMBRIAN_INLINE Sum(double length, const Values& values) : values_(values) {
            for (std::size_t j = 0; j < kStages; ++j)
                scaled_[j] = length * weight(j);
        }
        // Adds the terms from slot c on.
        template <std::size_t... kJ>
        CAMBRIAN_INLINE Simd4d add(Simd4d sum, int c, std::index_sequence<kJ...>) const {
            (add_term<kJ>(sum, c), ...);
            return sum;
        }
        // Adds the terms of one slot.
        template <std::size_t... kJ>
        CAMBRIAN_INLINE double add_one(double sum, int c, std::index_sequence<kJ...>) const {
            ((weight(kJ) != 0.0 ? sum += scaled_[kJ] * values_[kJ][c] : sum), ...);
            return sum;
        }

    private:
        static constexpr double weight(std::size_t j) {
            if (kRow == kErrorRow) return Tableau::kErrors[j];
            return j < kLast ? Tableau::kRows[kRow < kStages ? kRow : 0][j < kLast ? j : 0] : 0.0;
        }
        template <std::size_t kJ>
        CAMBRIAN_INLINE void add_term(Simd4d& sum, int c) const {
            if constexpr (weight(kJ) != 0.0) sum += scaled_[kJ] * load_lanes(values_[kJ] + c);
        }

        Values values_;
        double scaled_[kStages];
    };

    // RMS over all coordinates of the errors of position / (0.1 m or rad) and of speed /
    // (1 + |speed|), in tolerances.
    template <class Stages>
    CAMBRIAN_INLINE double error(Stages stages) const {
        const int slots = coordinate_slots(system_.model);
        const Sum<kErrorRow> add_speeds(request_.length, speeds_);
        const Sum<kErrorRow> add_accelerations(request_.length, accelerations_);
        Simd4d sum = {};
        for (int c = 0; c < slots; c += kLanes) {
            const Simd4d position = kPerPosition * add_speeds.add(Simd4d{}, c, stages);
            const Simd4d size = 1.0 + magnitude(load_lanes(result_.end.speed + c));
            const Simd4d speed = add_accelerations.add(Simd4d{}, c, stages) / size;
            sum += position * position + speed * speed;
        }
        const double mean = sum_of(sum) / (2.0 * coordinate_count(system_.model));
        return std::sqrt(mean) / request_.tolerance;
    }

    const MotionSystem& system_;
    const StepRequest& request_;
    EvaluationCache& cache_;
    StepResult& result_;
    Motion motions_[kLast];  // of the inner stages; [0] is unused
    MotionRate rates_[kLast];
    Values speeds_{}, accelerations_{}, powers_{};
};

}  // namespace cambrian
