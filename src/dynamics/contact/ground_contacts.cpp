#include "dynamics/contact/ground_contacts.h"

#include "core/assert.h"

#include <cmath>

namespace cambrian {
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
