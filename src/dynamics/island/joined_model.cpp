#include "dynamics/island/joined_model.h"

#include "core/assert.h"
#include "dynamics/model/forcing.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

using M = PlanarModel;

constexpr PerBody M::*kBodyNumbers[] = {&M::mass,
                                        &M::inertia,
                                        &M::inverse_mass,
                                        &M::inverse_inertia,
                                        &M::parent_anchor_x,
                                        &M::parent_anchor_y,
                                        &M::child_anchor_x,
                                        &M::child_anchor_y,
                                        &M::pivot_x,
                                        &M::pivot_y,
                                        &M::reach_x,
                                        &M::reach_y,
                                        &M::pivot_inertia,
                                        &M::rest_angle,
                                        &M::axis_x,
                                        &M::axis_y,
                                        &M::limit_low,
                                        &M::limit_high,
                                        &M::slides,
                                        &M::max_effort,
                                        &M::effective_inertia,
                                        &M::length_square,
                                        &M::width_square};
constexpr PerBody MotorLaw::*kMotorNumbers[] = {
    &MotorLaw::tracking,  &MotorLaw::direct,   &MotorLaw::rate_scale, &MotorLaw::rate_floor,
    &MotorLaw::stiffness, &MotorLaw::strength, &MotorLaw::damping};
constexpr PerPart M::*kPartNumbers[] = {&M::part_x,      &M::part_y,    &M::part_angle,
                                        &M::part_cosine, &M::part_sine, &M::half_length,
                                        &M::half_width,  &M::radius};
constexpr PerTree M::*kTreeNumbers[] = {&M::tree_mass, &M::rest_center_x, &M::rest_center_y,
                                        &M::rest_root_angle};

// An index of the member becomes one of all; -1 stays.
int moved(int index, int begin) {
    return index < 0 ? index : index + begin;
}

class ModelJoiner {
public:
    ModelJoiner() {
        joined_.contact_count = kMaxContacts;
        joined_.member_count = 0;
        for (int slot = 0; slot < kMaxBodies; ++slot) {
            joined_.parent_slot[slot] = slot;
            joined_.stretch_slot[slot] = -1;
        }
    }

    void add(const PlanarModel& member) {
        CAMBRIAN_ASSERT(joined_.body_count + member.body_count <= kMaxBodies &&
                            joined_.part_count + member.part_count <= kMaxParts &&
                            joined_.tree_count + member.tree_count <= kMaxTrees,
                        "joined bodies have room");
        CAMBRIAN_ASSERT(member.loop_joints.empty(), "joined bodies have no closed loops");
        add_bodies(member);
        add_trees(member);
        add_parts(member);
        add_pairs(member);
        joined_.density = member.density;
        joined_.total_mass += member.total_mass;
        joined_.has_slides = joined_.has_slides || member.has_slides;
        joined_.stretch_count += member.stretch_count;
        joined_.body_count += member.body_count;
        joined_.tree_count += member.tree_count;
        joined_.part_count += member.part_count;
        joined_.member_begin[++joined_.member_count] = joined_.body_count;
        joined_.tree_begin[joined_.tree_count] = joined_.body_count;
    }

    PlanarModel take() {
        for (int i = joined_.part_count; i < round_up_to_lanes(joined_.part_count); ++i) {
            joined_.part_body[i] = joined_.part_body[0];
            joined_.part_x[i] = joined_.part_x[0];
            joined_.part_y[i] = joined_.part_y[0];
        }
        return std::move(joined_);
    }

private:
    void add_bodies(const PlanarModel& member) {
        const int begin = joined_.body_count;
        const int count = member.body_count;
        for (const auto numbers : kBodyNumbers)
            std::copy_n(member.*numbers, count, joined_.*numbers + begin);
        for (const auto numbers : kMotorNumbers)
            std::copy_n(member.motor.*numbers, count, joined_.motor.*numbers + begin);
        std::copy_n(member.motion, count, joined_.motion + begin);
        std::copy_n(member.motor_mode, count, joined_.motor_mode + begin);
        joined_.roots |= member.roots << begin;
        for (int i = 0; i < count; ++i) {
            joined_.parent[begin + i] = moved(member.parent[i], begin);
            joined_.parent_slot[begin + i] = member.parent_slot[i] + begin;
            joined_.root_path[begin + i] = member.root_path[i] << begin;
            joined_.stretch_slot[begin + i] = moved(member.stretch_slot[i], begin);
        }
    }

    void add_trees(const PlanarModel& member) {
        const int begin = joined_.tree_count;
        for (const auto numbers : kTreeNumbers)
            std::copy_n(member.*numbers, member.tree_count, joined_.*numbers + begin);
        for (int t = 0; t < member.tree_count; ++t) {
            joined_.tree_begin[begin + t] = member.tree_begin[t] + joined_.body_count;
            const TreeMembers& from = member.members_of(t);
            TreeMembers& to = joined_.members.emplace_back();
            std::copy_n(from.share, member.body_count, to.share + joined_.body_count);
            std::copy_n(from.membership, member.body_count, to.membership + joined_.body_count);
        }
    }

    void add_parts(const PlanarModel& member) {
        const int begin = joined_.part_count;
        const int count = member.part_count;
        for (const auto numbers : kPartNumbers)
            std::copy_n(member.*numbers, count, joined_.*numbers + begin);
        std::copy_n(member.corner_x, 4 * count, joined_.corner_x + 4 * begin);
        std::copy_n(member.corner_y, 4 * count, joined_.corner_y + 4 * begin);
        for (int i = 0; i < count; ++i) {
            joined_.part_body[begin + i] = member.part_body[i] + joined_.body_count;
            joined_.part_joint[begin + i] = moved(member.part_joint[i], joined_.body_count);
        }
        if (member.measured_parts != 0) joined_.measured_parts |= member.measured_parts << begin;
    }

    // Adds the pairs within the member, and each of its boxes with each box before.
    void add_pairs(const PlanarModel& member) {
        const int begin = joined_.part_count;
        const auto pair = [](int first, int second) {
            return PartPair{static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)};
        };
        for (const PartPair& own : member.colliding_pairs)
            joined_.colliding_pairs.push_back(pair(begin + own.first, begin + own.second));
        for (int other = 0; other < begin; ++other) {
            for (int i = 0; i < member.part_count; ++i)
                joined_.colliding_pairs.push_back(pair(other, begin + i));
        }
    }

    PlanarModel joined_;
};

}  // namespace

PlanarModel join_models(std::span<const PlanarModel* const> members) {
    CAMBRIAN_ASSERT(!members.empty(), "something to join");
    ModelJoiner joiner;
    for (const PlanarModel* member : members)
        joiner.add(*member);
    return joiner.take();
}

}  // namespace cambrian
