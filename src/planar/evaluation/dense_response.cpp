#include "planar/evaluation/accelerations.h"
#include "planar/model/dense_lanes.h"

namespace cambrian {
namespace {

// Sums over all angles the rates times the arms turned by a quarter, minus the squared spins times
// the arms.
template <int kBlocks, bool kSpins>
CAMBRIAN_INLINE BodyVectors<kBlocks> sum_arms(const PlanarModel& model, const Kinematics& k,
                                              const double* rates, double x, double y) {
    constexpr int lines = kBlocks * kLanes;
    const DenseForm& form = model.dense;
    BodyVectors<kBlocks> sum;
    sum.x.fill(x);
    sum.y.fill(y);
    for (int angle = 0; angle < model.body_count; ++angle) {
        const double cosine = k.cosine[angle];
        const double sine = k.sine[angle];
        const double square = kSpins ? k.spin[angle] * k.spin[angle] : 0.0;
        // (rate i - square) R as a complex number.
        const double along = -square * cosine - rates[angle] * sine;
        const double across = rates[angle] * cosine - square * sine;
        for (int b = 0; b < kBlocks; ++b) {
            const Simd4d d_x = load_lanes(form.arm_x + angle * lines + b * kLanes);
            const Simd4d d_y = load_lanes(form.arm_y + angle * lines + b * kLanes);
            sum.x[b] += along * d_x - across * d_y;
            sum.y[b] += across * d_x + along * d_y;
        }
    }
    return sum;
}

template <int kBlocks>
CAMBRIAN_INLINE void accelerate_centers(const PlanarModel& model, const Kinematics& k,
                                        BodyResponse& response) {
    const double* center = response.coordinate + model.body_count;
    const auto sum = sum_arms<kBlocks, true>(model, k, response.coordinate, center[0], center[1]);
    sum.x.store_members(model, response.x);
    sum.y.store_members(model, response.y);
}

template <int kBlocks>
CAMBRIAN_INLINE void spread(const PlanarModel& model, const Kinematics& k,
                            const PerCoordinate& rates, PerBody& spin, PerBody& velocity_x,
                            PerBody& velocity_y) {
    const double* center = rates + model.body_count;
    const auto sum = sum_arms<kBlocks, false>(model, k, rates, center[0], center[1]);
    sum.x.store_members(model, velocity_x);
    sum.y.store_members(model, velocity_y);
    BodyLanes<kBlocks> turn;
    turn.load(rates);
    turn.store_members(model, spin);
}

CAMBRIAN_INLINE void add_efforts(const PlanarModel& model, const PerBody& efforts, double* torque) {
    for (int i = 1; i < model.body_count; ++i) {
        torque[i] += efforts[i];
        torque[model.parent[i]] -= efforts[i];
    }
}

template <int kBlocks>
CAMBRIAN_INLINE void solve_impulse_blocks(const PlanarModel& model, const EvaluationCache& cache,
                                          const Loads& impulses, PerCoordinate& jump) {
    Levers<kBlocks> levers(model.dense, cache.kinematics);
    double sum_x = 0.0;
    double sum_y = 0.0;
    for (int body = 0; body < model.body_count; ++body) {
        sum_x += impulses.force_x[body];
        sum_y += impulses.force_y[body];
        levers.add_force(body, impulses.force_x[body], impulses.force_y[body]);
    }
    double own[std::size_t{kBlocks} * kLanes] = {};
    for (int i = 0; i < model.body_count; ++i)
        own[i] = impulses.torque[i];
    add_efforts(model, impulses.effort, own);
    BodyLanes<kBlocks> torque;
    torque.load(own);
    for (int b = 0; b < kBlocks; ++b)
        torque[b] += levers.torque(b);
    const double share = 1.0 / model.total_mass;
    store_coordinates(times_inverse(cache.inverse, model.body_count, torque), model.body_count,
                      share * sum_x, share * sum_y, jump);
}

template <int kBlocks>
CAMBRIAN_INLINE void solve_efforts_blocks(const PlanarModel& model, const EvaluationCache& cache,
                                          const PerBody& efforts, PerCoordinate& jump) {
    double own[std::size_t{kBlocks} * kLanes] = {};
    add_efforts(model, efforts, own);
    BodyLanes<kBlocks> torque;
    torque.load(own);
    store_coordinates(times_inverse(cache.inverse, model.body_count, torque), model.body_count, 0.0,
                      0.0, jump);
}

}  // namespace

void accelerate_dense_centers(const PlanarModel& model, const Kinematics& k,
                              BodyResponse& response) {
    if (model.dense.blocks == 1)
        accelerate_centers<1>(model, k, response);
    else
        accelerate_centers<2>(model, k, response);
}

void spread_dense_rates(const PlanarModel& model, const Kinematics& place,
                        const PerCoordinate& rates, PerBody& spin, PerBody& velocity_x,
                        PerBody& velocity_y) {
    if (model.dense.blocks == 1)
        spread<1>(model, place, rates, spin, velocity_x, velocity_y);
    else
        spread<2>(model, place, rates, spin, velocity_x, velocity_y);
}

void solve_dense_impulse(const PlanarModel& model, const EvaluationCache& cache,
                         const Loads& impulses, PerCoordinate& jump) {
    if (model.dense.blocks == 1)
        solve_impulse_blocks<1>(model, cache, impulses, jump);
    else
        solve_impulse_blocks<2>(model, cache, impulses, jump);
}

void solve_dense_efforts(const PlanarModel& model, const EvaluationCache& cache,
                         const PerBody& efforts, PerCoordinate& jump) {
    if (model.dense.blocks == 1)
        solve_efforts_blocks<1>(model, cache, efforts, jump);
    else
        solve_efforts_blocks<2>(model, cache, efforts, jump);
}

}  // namespace cambrian
