#include "planar/contact/fixed_contacts.h"

#include "core/assert.h"
#include "planar/contact/box_contacts.h"

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

namespace {

// World offsets that make up the offset of a corner from its body's centre.
struct BoxArms {
    double center_x, center_y;  // the box's centre
    double along_x, along_y;    // half the box's length
    double across_x, across_y;  // half its width
};

// Adds the corners from the lowest up, so that a mirror image has the same order.
void add_corners(const PlanarModel& model, const Kinematics& k, int part, const BoxArms& arms,
                 std::uint8_t face, ContactSet& contacts) {
    CAMBRIAN_TICK_ASSERT(model.part_body[part] < model.body_count, "a box of a body");
    const int b = model.part_body[part];
    const int lowest = (arms.along_y > 0.0 ? 0 : 1) + (arms.across_y > 0.0 ? 0 : 2);
    const int next = std::fabs(arms.along_y) < std::fabs(arms.across_y) ? 1 : 2;
    for (const int corner : {lowest, lowest ^ next, lowest ^ next ^ 3, lowest ^ 3}) {
        const double along = (corner & 1) != 0 ? 1.0 : -1.0;
        const double across = (corner & 2) != 0 ? 1.0 : -1.0;
        const double arm_y = arms.center_y + along * arms.along_y + across * arms.across_y;
        const double gap = k.y[b] + arm_y;
        if (gap > kContactMargin) continue;
        Contact* contact = contacts.make_room(gap);
        if (contact == nullptr) continue;
        Contact& c = *contact;
        c.id = 4 * part + corner;
        c.body_a = b;
        c.body_b = -1;
        c.part_a = part;
        c.part_b = -1;
        c.face_a = face;
        c.face_b = 0;
        c.point_x = model.corner_x[c.id];
        c.point_y = model.corner_y[c.id];
        c.normal_x = 0.0;
        c.normal_y = 1.0;
        c.arm_ax = arms.center_x + along * arms.along_x + across * arms.across_x;
        c.arm_ay = arm_y;
        c.arm_bx = 0.0;
        c.arm_by = 0.0;
        c.gap = gap;
        c.closing_speed = -(k.velocity_y[b] + k.spin[b] * c.arm_ax);
    }
}

}  // namespace

void detect_ground_contacts(const PlanarModel& model, const Kinematics& k, const PartPlaces& places,
                            ContactSet& contacts) {
    PerPart lowest;
    for (int part = 0; part < model.part_count; part += kLanes) {
        const Simd4d reach =
            magnitude(load_lanes(places.axis_y + part)) * load_lanes(places.half_length + part) +
            magnitude(load_lanes(places.axis_x + part)) * load_lanes(places.half_width + part);
        store_lanes(lowest + part, load_lanes(places.y + part) - reach);
    }
    for (int part = 0; part < model.part_count; ++part) {
        if (lowest[part] > kContactMargin) continue;
        const int b = model.part_body[part];
        const double axis_x = places.axis_x[part];
        const double axis_y = places.axis_y[part];
        const double length = places.half_length[part];
        const double width = places.half_width[part];
        const BoxArms arms{places.x[part] - k.x[b], places.y[part] - k.y[b], axis_x * length,
                           axis_y * length,         -axis_y * width,         axis_x * width};
        add_corners(model, k, part, arms, static_cast<std::uint8_t>(face_toward(-axis_y, -axis_x)),
                    contacts);
    }
}

}  // namespace cambrian
