#pragma once

// The numbers of a model, by what each of them belongs to. What copies models goes through these
// lists.

#include "planar/model/planar_model.h"

namespace cambrian {

inline constexpr PerBody PlanarModel::*kBodyNumbers[] = {&PlanarModel::mass,
                                                         &PlanarModel::inertia,
                                                         &PlanarModel::inverse_mass,
                                                         &PlanarModel::inverse_inertia,
                                                         &PlanarModel::parent_anchor_x,
                                                         &PlanarModel::parent_anchor_y,
                                                         &PlanarModel::child_anchor_x,
                                                         &PlanarModel::child_anchor_y,
                                                         &PlanarModel::pivot_x,
                                                         &PlanarModel::pivot_y,
                                                         &PlanarModel::reach_x,
                                                         &PlanarModel::reach_y,
                                                         &PlanarModel::pivot_inertia,
                                                         &PlanarModel::rest_angle,
                                                         &PlanarModel::axis_x,
                                                         &PlanarModel::axis_y,
                                                         &PlanarModel::limit_low,
                                                         &PlanarModel::limit_high,
                                                         &PlanarModel::slides,
                                                         &PlanarModel::max_effort,
                                                         &PlanarModel::effective_inertia,
                                                         &PlanarModel::length_square,
                                                         &PlanarModel::width_square,
                                                         &PlanarModel::box_x,
                                                         &PlanarModel::box_y,
                                                         &PlanarModel::box_half_length,
                                                         &PlanarModel::box_half_width};
inline constexpr PerBody MotorLaw::*kMotorNumbers[] = {
    &MotorLaw::tracking,  &MotorLaw::direct,   &MotorLaw::rate_scale, &MotorLaw::rate_floor,
    &MotorLaw::stiffness, &MotorLaw::strength, &MotorLaw::damping};
inline constexpr PerPart PlanarModel::*kPartNumbers[] = {
    &PlanarModel::part_x,      &PlanarModel::part_y,    &PlanarModel::part_angle,
    &PlanarModel::part_cosine, &PlanarModel::part_sine, &PlanarModel::half_length,
    &PlanarModel::half_width,  &PlanarModel::radius};
inline constexpr PerTree PlanarModel::*kTreeNumbers[] = {
    &PlanarModel::tree_mass, &PlanarModel::rest_center_x, &PlanarModel::rest_center_y,
    &PlanarModel::rest_root_angle};

}  // namespace cambrian
