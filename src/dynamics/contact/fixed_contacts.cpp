#include "dynamics/contact/fixed_contacts.h"

#include "dynamics/contact/box_contacts.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

struct Reach {
    double low_x, low_y, high_x, high_y;  // m
};

// Returns an upright box that contains the part, enlarged by a margin (m).
Reach reach_of(const PartPlaces& places, int part, double margin = kContactMargin) {
    const double along = std::fabs(places.axis_x[part]);
    const double across = std::fabs(places.axis_y[part]);
    const double length = places.half_length[part];
    const double width = places.half_width[part];
    const double x = along * length + across * width + margin;
    const double y = across * length + along * width + margin;
    return {places.x[part] - x, places.y[part] - y, places.x[part] + x, places.y[part] + y};
}

bool meet(const Reach& reach, const FixedBox& box) {
    return reach.low_x < box.high.x() && box.low.x() < reach.high_x && reach.low_y < box.high.y() &&
           box.low.y() < reach.high_y;
}

// The moving box is body a, whichever of the two is the incident one.
void add_points(const Kinematics& k, const PartPlaces& places, const BoxManifold& manifold,
                Contact c, ContactSet& contacts) {
    const double side = manifold.first_is_incident ? 1.0 : -1.0;
    c.normal_x = side * manifold.normal_x;
    c.normal_y = side * manifold.normal_y;
    c.face_a = touching_face(places, c.part_a, -c.normal_x, -c.normal_y);
    const int a = c.body_a;
    const int first_id = c.id + (manifold.first_is_incident ? 4 : 0);
    for (int i = 0; i < manifold.count; ++i) {
        c.id = first_id + manifold.corner[i];
        c.arm_ax = manifold.x[i] - k.x[a];
        c.arm_ay = manifold.y[i] - k.y[a];
        c.point_x = k.cosine[a] * c.arm_ax + k.sine[a] * c.arm_ay;
        c.point_y = k.cosine[a] * c.arm_ay - k.sine[a] * c.arm_ax;
        c.gap = manifold.gap[i];
        c.closing_speed = -(c.normal_x * (k.velocity_x[a] - k.spin[a] * c.arm_ay) +
                            c.normal_y * (k.velocity_y[a] + k.spin[a] * c.arm_ax));
        contacts.add(c);
    }
}

PlacedBox placed_box(const FixedBox& box) {
    return {box.center.x(), box.center.y(),  box.axis.x(),
            box.axis.y(),   box.half_length, box.half_width};
}

double smaller_side(const FixedBox& box) {
    return 2.0 * std::min(box.half_length, box.half_width);
}

// Whether no axis separates two boxes by more than a distance (m).
bool is_within(const PlacedBox& a, const PlacedBox& b, double distance) {
    const BoxRelation<double> relation = relation_of(a, b);
    const AxisGaps<double> own = axis_gaps(a, b, relation);
    const AxisGaps<double> other = axis_gaps(b, a, relation);
    return std::max({own.length, own.width, other.length, other.width}) <= distance;
}

// Returns an upright box that contains all parts.
Reach reach_of_all(const PlanarModel& model, const PartPlaces& places) {
    Reach all = reach_of(places, 0);
    for (int part = 1; part < model.part_count; ++part) {
        const Reach reach = reach_of(places, part);
        all.low_x = std::min(all.low_x, reach.low_x);
        all.low_y = std::min(all.low_y, reach.low_y);
        all.high_x = std::max(all.high_x, reach.high_x);
        all.high_y = std::max(all.high_y, reach.high_y);
    }
    return all;
}

}  // namespace

void detect_fixed_contacts(const PlanarModel& model, const Kinematics& k, const PartPlaces& places,
                           std::span<const FixedBox> fixed, ContactSet& contacts) {
    int near[kMostFixedBoxes];
    int near_count = 0;
    const Reach all = reach_of_all(model, places);
    const auto count = std::min<std::size_t>(fixed.size(), kMostFixedBoxes);
    for (std::size_t box = 0; box < count; ++box) {
        if (meet(all, fixed[box])) near[near_count++] = static_cast<int>(box);
    }
    if (near_count == 0) return;
    for (int part = 0; part < model.part_count; ++part) {
        const Reach reach = reach_of(places, part);
        for (int i = 0; i < near_count; ++i) {
            const FixedBox& box = fixed[static_cast<std::size_t>(near[i])];
            if (!meet(reach, box)) continue;
            const BoxManifold manifold =
                collide_boxes(placed_box(places, part), placed_box(box), kContactMargin);
            if (manifold.count == 0) continue;
            Contact contact;
            contact.id = kFixedContactIds + kIdsPerPair * (part * kMostFixedBoxes + near[i]);
            contact.body_a = model.part_body[part];
            contact.part_a = part;
            add_points(k, places, manifold, contact, contacts);
        }
    }
}

double count_looks_at_fixed(const BoxEnds& ends, const BoxTravels& travels, const BoxSides& sides,
                            std::span<const FixedBox> fixed) {
    fixed = fixed.first(std::min<std::size_t>(fixed.size(), kMostFixedBoxes));
    double thinnest = 1e9;
    for (const FixedBox& box : fixed)
        thinnest = std::min(thinnest, smaller_side(box));
    double looks = 1.0;
    for (int part = 0; part < ends.model.part_count; ++part) {
        const double travel = travel_of(ends, travels, part);
        if (travel <= std::min(sides.thin[part], thinnest)) continue;
        const Reach reach = reach_of(ends.from, part, travel);
        for (const FixedBox& box : fixed) {
            const double parts = travel / std::min(sides.thin[part], smaller_side(box));
            if (parts <= looks || !meet(reach, box)) continue;
            if (is_within(placed_box(ends.from, part), placed_box(box), travel)) looks = parts;
        }
    }
    return looks;
}

}  // namespace cambrian
