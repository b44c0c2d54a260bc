#include "planar/island/joined_model.h"

#include "core/assert.h"
#include "planar/island/model_fields.h"
#include "planar/model/planar_model.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

// An index of the member becomes one of all; -1 stays.
int moved(int index, int begin) {
    return index < 0 ? index : index + begin;
}

class ModelJoiner {
public:
    ModelJoiner() {
        joined_.contact_count = kMaxContacts;
        joined_.member_count = 0;
        clear_slots(joined_, 0);
    }

    void add(const PlanarModel& member) {
        CAMBRIAN_ASSERT(joined_.body_count + member.body_count <= kMaxBodies &&
                            joined_.part_count + member.part_count <= kMaxParts &&
                            joined_.tree_count + member.tree_count <= kMaxTrees,
                        "joined bodies have room");
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
        order_by_depth(joined_);
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
