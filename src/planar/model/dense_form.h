#pragma once

// Constants of the dense equations of motion, for a few bodies with revolute joints in absolute
// angles (planar/README.md 5). About the tree's centre of mass a body's centre is the sum over
// all angles k of R(q_k) d_k with constant arms d_k. The mass matrix and the velocity terms are
//     M_ij = A_ij cos(q_i - q_j) + B_ij sin(q_i - q_j),
//     M q'' = Q + sum_j (B_ij cos(q_i - q_j) - A_ij sin(q_i - q_j)) q_j'^2
// with constant A and B. The centre of mass moves independently.

namespace cambrian {

struct PlanarModel;

inline constexpr int kMaxDenseBlocks = 2;  // of kLanes bodies; for more the tree form is cheaper
inline constexpr int kMaxDenseBodies = 8;

// Stored by columns, each padded to the blocks. The padding is 0, and 1 on A's diagonal.
using DenseMatrix = double[kMaxDenseBodies * kMaxDenseBodies];

struct DenseForm {
    int blocks = 0;                   // 0 where the form does not apply
    DenseMatrix inertia_cosine = {};  // kg m^2; A
    DenseMatrix inertia_sine = {};    // kg m^2; B
    DenseMatrix arm_x = {};           // m; d of all bodies, one column for each angle
    DenseMatrix arm_y = {};
    DenseMatrix lever_x = {};  // m; d of all angles, one column for each body
    DenseMatrix lever_y = {};
};

// Computes the form from the model's masses and joints. `blocks` is 0 unless the model is
// one tree of at most kMaxDenseBodies bodies with revolute joints only.
void derive_dense_form(const PlanarModel& model, DenseForm& form);

}  // namespace cambrian
