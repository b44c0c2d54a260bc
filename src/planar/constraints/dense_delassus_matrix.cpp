// With the generalised force J of each row's unit impulse on the angles and its total force F,
//     W_rs = J_r M^-1 J_s' + F_r . F_s / mass.

#include "core/assert.h"
#include "planar/constraints/rows.h"
#include "planar/model/dense_lanes.h"

namespace cambrian {
namespace {

template <int kBlocks>
class DenseRows {
public:
    CAMBRIAN_INLINE DenseRows(const PlanarModel& model, const EvaluationCache& cache,
                              ConstraintSystem& rows)
        : model_(model), cache_(cache), rows_(rows) {}

    CAMBRIAN_INLINE void fill() {
        for (int row = 0; row < rows_.count; ++row)
            place(row);
        for (int row = rows_.count; row < rows_.stride; ++row)
            clear(row);
        const double share = 1.0 / model_.total_mass;
        for (int row = 0; row < rows_.count; ++row)
            couple(row, share);
    }

private:
    CAMBRIAN_INLINE void clear(int row) {
        torque_[row] = {};
        force_x_[row] = 0.0;
        force_y_[row] = 0.0;
    }

    CAMBRIAN_INLINE void place(int row) {
        clear(row);
        const int a = rows_[row].body_a;
        if (rows_[row].kind == RowKind::kLimit) {
            torque_[row].add_at(a, rows_[row].dir_x);
            torque_[row].add_at(model_.parent[a], -rows_[row].dir_x);
            return;
        }
        const double x = rows_[row].dir_x;
        const double y = rows_[row].dir_y;
        Levers<kBlocks> levers(model_.dense, cache_.kinematics);
        levers.add_force(a, x, y);
        const int b = rows_[row].body_b;
        if (b >= 0) {
            levers.add_force(b, -x, -y);
        } else {
            force_x_[row] = x;
            force_y_[row] = y;
        }
        for (int block = 0; block < kBlocks; ++block)
            torque_[row][block] = levers.torque(block);
        torque_[row].add_at(a, rows_[row].moment_a);
        if (b >= 0) torque_[row].add_at(b, -rows_[row].moment_b);
    }

    CAMBRIAN_INLINE void couple(int row, double share) {
        const BodyLanes<kBlocks> turn =
            times_inverse(cache_.inverse, model_.body_count, torque_[row]);
        const Simd4d x = all_lanes(share * force_x_[row]);
        const Simd4d y = all_lanes(share * force_y_[row]);
        double* line = rows_.line(row);
        for (int column = 0; column < rows_.count; column += kLanes) {
            Simd4d product[kLanes];
            for (int lane = 0; lane < kLanes; ++lane) {
                product[lane] = turn[0] * torque_[column + lane][0];
                for (int b = 1; b < kBlocks; ++b)
                    product[lane] += turn[b] * torque_[column + lane][b];
            }
            store_lanes(line + column, sums_of(product) + x * load_lanes(force_x_ + column) +
                                           y * load_lanes(force_y_ + column));
        }
    }

    // Returns the sum over the lanes of each of the four.
    CAMBRIAN_INLINE static Simd4d sums_of(const Simd4d (&of)[kLanes]) {
        const Simd4d first = pair_sums(of[0], of[1]);
        const Simd4d second = pair_sums(of[2], of[3]);
        return __builtin_shufflevector(first, second, 0, 1, 4, 5) +
               __builtin_shufflevector(first, second, 2, 3, 6, 7);
    }

    const PlanarModel& model_;
    const EvaluationCache& cache_;
    ConstraintSystem& rows_;
    BodyLanes<kBlocks> torque_[kMaxRows];
    double force_x_[kMaxRows], force_y_[kMaxRows];  // of all of the creature; 0 between its bodies
};

}  // namespace

void fill_dense_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                                ConstraintSystem& rows) {
    CAMBRIAN_TICK_ASSERT(cache.is_inverted, "the inverse is there");
    CAMBRIAN_TICK_ASSERT(model.body_count <= kMaxDenseBodies, "few bodies");
    if (model.dense.blocks == 1)
        DenseRows<1>(model, cache, rows).fill();
    else
        DenseRows<2>(model, cache, rows).fill();
}

}  // namespace cambrian
