#include "dynamics/contact/self_contacts.h"

#include "core/assert.h"
#include "dynamics/contact/box_contacts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cambrian {
namespace {

static_assert(kMostPairs % kLanes == 0, "four pairs are tested at once");

constexpr double kSpare = 0.25;  // m, enlargement of the bounding circles

// Whether the bounding circles of two boxes are nearer than the margin.
bool circles_near(const PlanarModel& model, const PartPlaces& places, const PartPair& pair,
                  double margin) {
    const double x = places.x[pair.second] - places.x[pair.first];
    const double y = places.y[pair.second] - places.y[pair.first];
    const double reach = model.radius[pair.first] + model.radius[pair.second] + margin;
    return x * x + y * y < reach * reach;
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

// The list is valid until a box has moved by half the enlargement relative to part 0.
CAMBRIAN_INLINE bool PairList::has_expired(const PlanarModel& model,
                                           const PartPlaces& places) const {
    if (!built_) return true;
    Simd4d farthest = {};
    for (int part = 0; part < model.part_count; part += kLanes) {
        const Simd4d x = load_lanes(places.x + part) - places.x[0] - load_lanes(built_x_ + part);
        const Simd4d y = load_lanes(places.y + part) - places.y[0] - load_lanes(built_y_ + part);
        farthest = greater(farthest, x * x + y * y);
    }
    return largest_of(farthest) > 0.25 * kSpare * kSpare;
}

// Adds the contacts of a pair unless an axis of one box separates them.
CAMBRIAN_INLINE void PairList::add_contacts(const PlanarModel& model, const Kinematics& kinematics,
                                            const PartPlaces& places, int pair,
                                            ContactSet& contacts) {
    const int first = first_[pair];
    const int second = second_[pair];
    const int own = by_second_[pair] ? second : first;
    const int other = by_second_[pair] ? first : second;
    if (is_separated_by(placed_box(places, own), placed_box(places, other), kContactMargin)) return;
    by_second_[pair] = !by_second_[pair];
    const BoxManifold manifold =
        collide_boxes(placed_box(places, first), placed_box(places, second), kContactMargin);
    if (manifold.count > 0) add_points(model, kinematics, places, index_[pair], manifold, contacts);
}

void PairList::detect(const PlanarModel& model, const Kinematics& kinematics,
                      const PartPlaces& places, ContactSet& contacts) {
    if (model.colliding_pairs.empty()) return;
    if (has_expired(model, places)) rebuild(model, places);
    for (int begin = 0; begin < count_; begin += kLanes) {
        const Simd4d x = gather(places.x, second_ + begin) - gather(places.x, first_ + begin);
        const Simd4d y = gather(places.y, second_ + begin) - gather(places.y, first_ + begin);
        const unsigned far = true_lanes(x * x + y * y >= load_lanes(reach_squared_ + begin));
        // What is not a number is not far; so the padding is left out by its place.
        for (unsigned near = first_lanes(count_ - begin) & ~far; near != 0; near &= near - 1)
            add_contacts(model, kinematics, places, begin + std::countr_zero(near), contacts);
    }
}

void PairList::rebuild(const PlanarModel& model, const PartPlaces& places) {
    built_ = true;
    for (int part = 0; part < round_up_to_lanes(model.part_count); ++part) {
        built_x_[part] = places.x[part] - places.x[0];
        built_y_[part] = places.y[part] - places.y[0];
    }
    count_ = 0;
    for (std::size_t i = 0; i < model.colliding_pairs.size(); ++i) {
        const PartPair pair = model.colliding_pairs[i];
        if (!circles_near(model, places, pair, kContactMargin + kSpare)) continue;
        const double reach = model.radius[pair.first] + model.radius[pair.second] + kContactMargin;
        CAMBRIAN_TICK_ASSERT(count_ < kMostPairs, "pairs have room");
        CAMBRIAN_TICK_ASSERT(pair.first < pair.second && pair.second < model.part_count,
                             "two boxes");
        index_[count_] = static_cast<int>(i);
        first_[count_] = pair.first;
        second_[count_] = pair.second;
        reach_squared_[count_] = reach * reach;
        by_second_[count_] = false;
        ++count_;
    }
    for (int pair = count_; pair < round_up_to_lanes(count_); ++pair) {
        first_[pair] = second_[pair] = 0;
        reach_squared_[pair] = 0.0;
    }
}

}  // namespace cambrian
