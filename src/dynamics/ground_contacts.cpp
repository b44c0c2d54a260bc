#include "dynamics/ground_contacts.h"

#include <cmath>

namespace cambrian {
namespace {

void add_corner(const PlanarModel& model, const Kinematics& k, const PartPlaces& places, int part,
                int corner, ContactSet& contacts) {
    const int b = model.part_body[part];
    const double along = (corner & 1) != 0 ? model.half_length[part] : -model.half_length[part];
    const double across = (corner & 2) != 0 ? model.half_width[part] : -model.half_width[part];
    Contact c;
    c.point_x =
        model.part_x[part] + model.part_cosine[part] * along - model.part_sine[part] * across;
    c.point_y =
        model.part_y[part] + model.part_sine[part] * along + model.part_cosine[part] * across;
    c.arm_ax = k.cosine[b] * c.point_x - k.sine[b] * c.point_y;
    c.arm_ay = k.sine[b] * c.point_x + k.cosine[b] * c.point_y;
    c.gap = k.y[b] + c.arm_ay;
    if (c.gap > kContactMargin) return;
    c.id = 4 * part + corner;
    c.body_a = b;
    c.part_a = part;
    c.face_a = static_cast<std::uint8_t>(face_toward(-places.axis_y[part], -places.axis_x[part]));
    c.closing_speed = -(k.velocity_y[b] + k.spin[b] * c.arm_ax);
    contacts.add(c);
}

}  // namespace

void collect_ground_contacts(const PlanarModel& model, const Kinematics& kinematics,
                             const PartPlaces& places, ContactSet& contacts) {
    for (int part = 0; part < model.part_count; ++part) {
        const double reach = std::fabs(places.axis_y[part]) * model.half_length[part] +
                             std::fabs(places.axis_x[part]) * model.half_width[part];
        if (places.y[part] - reach > kContactMargin) continue;
        for (int corner = 0; corner < 4; ++corner)
            add_corner(model, kinematics, places, part, corner, contacts);
    }
}

}  // namespace cambrian
