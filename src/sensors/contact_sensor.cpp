// Touch of each face of a part, by the ground or another part: +1 touching, -1 not (Sims 1994).

#include "sensors/kinds.h"

namespace cambrian {
namespace {

Face mirrored(Face face) {
    if (face == Face::kLeft) return Face::kRight;
    if (face == Face::kRight) return Face::kLeft;
    return face;
}

double read_contact(const BodyView& body, std::size_t part, std::size_t channel, int handedness) {
    const auto face = static_cast<Face>(channel);
    return body.face_touched(part, handedness < 0 ? mirrored(face) : face) ? 1.0 : -1.0;
}

}  // namespace

void add_contact_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "contact",
                 .label = "Contact",
                 .channels = {{"contact-distal", "Contact, far end"},
                              {"contact-left", "Contact, left"},
                              {"contact-proximal", "Contact, near end"},
                              {"contact-right", "Contact, right"}},
                 .read = read_contact});
}

}  // namespace cambrian
