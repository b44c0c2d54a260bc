#include "dynamics/ground_contacts.h"

#include <cmath>

namespace cambrian {
namespace {

// World axes of a box's length.
struct BoxAxis {
    double x, y;
};

inline BoxAxis box_axis(const PlanarModel& model, const Kinematics& k, int part, int body) {
    return {k.cosine[body] * model.part_cosine[part] - k.sine[body] * model.part_sine[part],
            k.sine[body] * model.part_cosine[part] + k.cosine[body] * model.part_sine[part]};
}

void add_corner(const PlanarModel& model, const Kinematics& k, int part, int corner,
                ContactSet& contacts) {
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
    const BoxAxis axis = box_axis(model, k, part, b);
    c.face_a = static_cast<std::uint8_t>(face_toward(-axis.y, -axis.x));
    c.closing_speed = -(k.velocity_y[b] + k.spin[b] * c.arm_ax);
    contacts.add(c);
}

}  // namespace

void ContactSet::add(const Contact& contact) {
    if (count < kMaxContacts) {
        items[count++] = contact;
        return;
    }
    int farthest = 0;
    for (int i = 1; i < count; ++i) {
        if (items[i].gap > items[farthest].gap) farthest = i;
    }
    if (contact.gap < items[farthest].gap) items[farthest] = contact;
}

Face face_toward(double x, double y) {
    if (std::fabs(x) >= std::fabs(y)) return x > 0.0 ? Face::kDistal : Face::kProximal;
    return y > 0.0 ? Face::kLeft : Face::kRight;
}

void collect_ground_contacts(const PlanarModel& model, const Kinematics& k, ContactSet& contacts) {
    for (int part = 0; part < model.part_count; ++part) {
        const int b = model.part_body[part];
        const BoxAxis axis = box_axis(model, k, part, b);
        const double center =
            k.y[b] + k.sine[b] * model.part_x[part] + k.cosine[b] * model.part_y[part];
        const double reach = std::fabs(axis.y) * model.half_length[part] +
                             std::fabs(axis.x) * model.half_width[part];
        if (center - reach > kContactMargin) continue;
        for (int corner = 0; corner < 4; ++corner)
            add_corner(model, k, part, corner, contacts);
    }
}

}  // namespace cambrian
