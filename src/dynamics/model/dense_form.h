#pragma once

// Constants of the motion of a few bodies joined by rotary joints in their absolute angles. About
// the tree's centre of mass a body's centre is the sum over all angles k of R(q_k) d_k, with arms
// d_k that never change. So the mass matrix and the forces that go with the speeds are
//     M_ij = A_ij cos(q_i - q_j) + B_ij sin(q_i - q_j),
//     M q'' = Q + sum_j (B_ij cos(q_i - q_j) - A_ij sin(q_i - q_j)) q_j'^2
// with A and B constant, and the centre of mass moves on its own.

namespace cambrian {

struct PlanarModel;

inline constexpr int kMaxDenseBlocks = 2;  // of kLanes bodies; for more the elimination is cheaper
inline constexpr int kMaxDenseBodies = 8;

// By columns, each as long as the blocks; what belongs to no body is 0, on A's diagonal 1.
using DenseMatrix = double[kMaxDenseBodies * kMaxDenseBodies];

struct DenseForm {
    int blocks = 0;                   // 0 where the form does not apply
    DenseMatrix inertia_cosine = {};  // kg m^2; A
    DenseMatrix inertia_sine = {};    // kg m^2; B
    DenseMatrix arm_x = {};           // m; d, the column of an angle has every body's
    DenseMatrix arm_y = {};
    DenseMatrix lever_x = {};  // m; the same, the column of a body has every angle's
    DenseMatrix lever_y = {};
    bool single_boxes = false;                 // every body is one box; then its sizes
    double half_length[kMaxDenseBodies] = {};  // m, along the body's x
    double half_width[kMaxDenseBodies] = {};   // m
};

// From the model's masses, joints and boxes; blocks is 0 unless they are one tree of few bodies
// with rotary joints only.
void derive_dense_form(const PlanarModel& model, DenseForm& form);

}  // namespace cambrian
