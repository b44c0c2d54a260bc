#include "planar/contact/self_contacts.h"

#include "core/assert.h"
#include "planar/contact/box_contacts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cambrian {
namespace {

static_assert(kMostPairs <= UINT16_MAX && kMaxParts <= UINT8_MAX + 1, "groups have small numbers");
static_assert(kMaxParts % kLanes == 0, "four boxes are loaded at once");

constexpr double kSpare = 0.25;  // m, enlargement of the bounding circles
constexpr double kBelowRounding = 1.0 - 1e-9;

// One box with the four others of a group.
struct BoxAndFour {
    Simd4dVector from_first;  // m, between the centres
    Simd4d reach;             // m, sum of the radii of the bounding circles
};

CAMBRIAN_INLINE Simd4dVector from_center(const PartPlaces& places, int first, int second) {
    return {load_lanes(places.x + second) - places.x[first],
            load_lanes(places.y + second) - places.y[first]};
}

CAMBRIAN_INLINE BoxAndFour box_and_four(const PlanarModel& model, const PartPlaces& places,
                                        int first, int second) {
    return {from_center(places, first, second),
            model.radius[first] + load_lanes(model.radius + second)};
}

CAMBRIAN_INLINE Simd4d squared_length(const Simd4dVector& vector) {
    return vector.x * vector.x + vector.y * vector.y;
}

// Returns the lanes in which no axis separates the boxes by more than the margin. What is not a
// number separates nothing.
CAMBRIAN_INLINE unsigned unseparated_lanes(const AxisGaps<Simd4d>& gaps) {
    return ~true_lanes(greater(gaps.length, gaps.width) > kContactMargin);
}

// Returns those of the lanes in which no axis of either box separates the two.
CAMBRIAN_INLINE unsigned touching_lanes(const PartPlaces& places, int first, int second,
                                        unsigned lanes) {
    const PlacedBox one = placed_box(places, first);
    const PlacedBoxes<Simd4d> four = four_boxes(places, second);
    const BoxRelation<Simd4d> relation = relation_of(one, four);
    lanes &= unseparated_lanes(axis_gaps(one, four, relation));
    return lanes == 0 ? 0 : lanes & unseparated_lanes(axis_gaps(four, one, relation));
}

// Returns the lanes in which no axis separates the boxes by more than this, m.
CAMBRIAN_INLINE unsigned reaching_lanes(const PartPlaces& places, int first, int second,
                                        const Simd4d& reach) {
    const PlacedBox one = placed_box(places, first);
    const PlacedBoxes<Simd4d> four = four_boxes(places, second);
    const BoxRelation<Simd4d> relation = relation_of(one, four);
    const AxisGaps<Simd4d> own = axis_gaps(one, four, relation);
    const AxisGaps<Simd4d> other = axis_gaps(four, one, relation);
    return true_lanes(greater(greater(own.length, own.width), greater(other.length, other.width)) <=
                      reach);
}

// Returns the most that one box moves past each of four others, at a place that the circles around
// both hold, in m, seen in the frame of the one. It does not grow as boxes turn together.
CAMBRIAN_INLINE Simd4d travel_beside(const BoxEnds& ends, const BoxTravels& travels, int first,
                                     int second) {
    const Simd4d turns = load_lanes(travels.turn + second) - travels.turn[first];
    const Simd4dVector move = moves_beside(ends, first, second);
    Simd4d travel =
        most_length(move.x, move.y) + load_lanes(ends.model.radius + second) * magnitude(turns);
    if (ends.model.stretch_count > 0) {
        const int block = first & -kLanes;
        travel += growths_of(ends, second) + growths_of(ends, block)[first - block];
    }
    return travel;
}

void add_points(const PlanarModel& model, const Kinematics& k, const PartPlaces& places,
                int pair_index, const BoxManifold& manifold, ContactSet& contacts) {
    const PartPair pair = model.colliding_pairs[static_cast<std::size_t>(pair_index)];
    Contact c;
    c.part_a = manifold.first_is_incident ? pair.first : pair.second;
    c.part_b = manifold.first_is_incident ? pair.second : pair.first;
    c.body_a = model.part_body[c.part_a];
    c.body_b = model.part_body[c.part_b];
    c.normal_x = manifold.normal_x;
    c.normal_y = manifold.normal_y;
    c.face_a = touching_face(places, c.part_a, -c.normal_x, -c.normal_y);
    c.face_b = touching_face(places, c.part_b, c.normal_x, c.normal_y);
    CAMBRIAN_TICK_ASSERT(c.body_a != c.body_b, "boxes of different bodies");
    for (int i = 0; i < manifold.count; ++i) {
        const int a = c.body_a;
        const int b = c.body_b;
        c.id = kGroundContactIds + kIdsPerPair * pair_index + (manifold.first_is_incident ? 4 : 0) +
               manifold.corner[i];
        c.arm_ax = manifold.x[i] - k.x[a];
        c.arm_ay = manifold.y[i] - k.y[a];
        c.arm_bx = manifold.x[i] - k.x[b];
        c.arm_by = manifold.y[i] - k.y[b];
        c.point_x = k.cosine[a] * c.arm_ax + k.sine[a] * c.arm_ay;
        c.point_y = k.cosine[a] * c.arm_ay - k.sine[a] * c.arm_ax;
        c.gap = manifold.gap[i];
        const double velocity_x =
            k.velocity_x[a] - k.spin[a] * c.arm_ay - k.velocity_x[b] + k.spin[b] * c.arm_by;
        const double velocity_y =
            k.velocity_y[a] + k.spin[a] * c.arm_ax - k.velocity_y[b] - k.spin[b] * c.arm_bx;
        c.closing_speed = -(c.normal_x * velocity_x + c.normal_y * velocity_y);
        contacts.add(c);
    }
}

}  // namespace

void PairList::group_pairs(const PlanarModel& model) {
    is_grouped_ = true;
    group_count_ = 0;
    for (std::size_t i = 0; i < model.colliding_pairs.size(); ++i) {
        const PartPair pair = model.colliding_pairs[i];
        CAMBRIAN_TICK_ASSERT(pair.first < pair.second && pair.second < model.part_count,
                             "two boxes");
        const auto begin = static_cast<std::uint8_t>(pair.second & -kLanes);
        const auto lane = static_cast<std::uint8_t>(1U << (pair.second - begin));
        if (group_count_ > 0) {
            Group& last = groups_[group_count_ - 1];
            if (last.first == pair.first && last.second == begin && last.lanes < lane) {
                last.lanes |= lane;
                continue;
            }
        }
        CAMBRIAN_TICK_ASSERT(group_count_ < kMostPairs, "pairs have room");
        groups_[group_count_++] = {static_cast<std::uint16_t>(i), pair.first, begin, lane, 0};
    }
}

// The list is valid until a box has moved by half the enlargement relative to part 0.
CAMBRIAN_INLINE bool PairList::has_expired(const PlanarModel& model,
                                           const PartPlaces& places) const {
    if (!is_built_) return true;
    Simd4d farthest = {};
    for (int part = 0; part < model.part_count; part += kLanes) {
        const Simd4d x = load_lanes(places.x + part) - places.x[0] - load_lanes(built_x_ + part);
        const Simd4d y = load_lanes(places.y + part) - places.y[0] - load_lanes(built_y_ + part);
        farthest = greater(farthest, squared_length({x, y}));
    }
    return largest_of(farthest) > 0.25 * kSpare * kSpare;
}

void PairList::rebuild(const PlanarModel& model, const PartPlaces& places) {
    is_built_ = true;
    for (int part = 0; part < round_up_to_lanes(model.part_count); ++part) {
        built_x_[part] = places.x[part] - places.x[0];
        built_y_[part] = places.y[part] - places.y[0];
    }
    listed_count_ = 0;
    for (int g = 0; g < group_count_; ++g) {
        const Group& group = groups_[g];
        const BoxAndFour boxes = box_and_four(model, places, group.first, group.second);
        const Simd4d reach = boxes.reach + (kContactMargin + kSpare);
        const unsigned near =
            group.lanes & true_lanes(squared_length(boxes.from_first) < reach * reach);
        if (near == 0) continue;
        listed_[listed_count_] = group;
        listed_[listed_count_++].near = static_cast<std::uint8_t>(near);
    }
}

// Adds the contacts of the boxes in these lanes.
void PairList::add_contacts(const PlanarModel& model, const Kinematics& kinematics,
                            const PartPlaces& places, const Group& group, unsigned lanes,
                            ContactSet& contacts) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        const BoxManifold manifold =
            collide_boxes(placed_box(places, group.first), placed_box(places, group.second + lane),
                          kContactMargin);
        if (manifold.count == 0) continue;
        const int before = std::popcount(group.lanes & ((1U << lane) - 1U));
        add_points(model, kinematics, places, group.index + before, manifold, contacts);
    }
}

// Boxes that are not in the list are too far apart to meet between two detections with one list. By
// the triangle inequality no pair moves farther than both of its boxes beside box 0, but for
// rounding.
double PairList::count_looks(const BoxEnds& ends, const BoxTravels& travels,
                             const BoxSides& sides) const {
    const Group* groups = was_rebuilt_ ? groups_ : listed_;
    const int count = was_rebuilt_ ? group_count_ : listed_count_;
    const Simd4d least = all_lanes(kBelowRounding * sides.thinnest);
    double looks = 1.0;
    for (int g = 0; g < count; ++g) {
        const int first = groups[g].first;
        const int second = groups[g].second;
        unsigned fast =
            (was_rebuilt_ ? groups[g].lanes : groups[g].near) &
            true_lanes(travels.beside[first] + load_lanes(travels.beside + second) > least);
        if (fast == 0) continue;
        const Simd4d thin = lesser(all_lanes(sides.thin[first]), load_lanes(sides.thin + second));
        const Simd4dVector before = from_center(ends.from, first, second);
        const Simd4dVector after = from_center(ends.to, first, second);
        Simd4d travel = most_length(after.x - before.x, after.y - before.y) +
                        (travels.swing[first] + load_lanes(travels.swing + second));
        fast &= true_lanes(travel > thin);
        if (fast == 0) continue;
        const Simd4d reach =
            ends.model.radius[first] + load_lanes(ends.model.radius + second) + travel;
        fast &= true_lanes(squared_length(before) <= reach * reach);
        if (fast == 0) continue;
        travel = lesser(travel, travel_beside(ends, travels, first, second));
        fast &= true_lanes(travel > thin);
        if (fast == 0) continue;
        fast &= reaching_lanes(ends.from, first, second, travel);
        const Simd4d parts = travel / thin;
        for (; fast != 0; fast &= fast - 1)
            looks = std::max(looks, parts[std::countr_zero(fast)]);
    }
    return looks;
}

void PairList::detect(const PlanarModel& model, const Kinematics& kinematics,
                      const PartPlaces& places, ContactSet& contacts) {
    if (model.colliding_pairs.empty()) return;
    if (!is_grouped_) group_pairs(model);
    was_rebuilt_ = has_expired(model, places);
    if (was_rebuilt_) rebuild(model, places);
    for (int l = 0; l < listed_count_; ++l) {
        const Group& group = listed_[l];
        const BoxAndFour boxes = box_and_four(model, places, group.first, group.second);
        const Simd4d reach = boxes.reach + kContactMargin;
        // A distance that is not a number is not far.
        const unsigned far = true_lanes(squared_length(boxes.from_first) >= reach * reach);
        const unsigned near = group.near & ~far;
        if (near == 0) continue;
        const unsigned touching = touching_lanes(places, group.first, group.second, near);
        if (touching != 0) add_contacts(model, kinematics, places, group, touching, contacts);
    }
}

}  // namespace cambrian
