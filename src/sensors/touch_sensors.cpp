// Senses of touch.

#include "sensors/frames.h"
#include "sensors/kinds.h"
#include "world/environment.h"

namespace cambrian {
namespace {

Face mirrored(Face face) {
    if (face == Face::kLeft) return Face::kRight;
    if (face == Face::kRight) return Face::kLeft;
    return face;
}

Face face_of(std::size_t channel, int handedness) {
    const auto face = static_cast<Face>(channel);
    return handedness < 0 ? mirrored(face) : face;
}

double read_contact(const SensorSite& site, double& /*memory*/) {
    const Face face = face_of(site.channel, site.mirror.across);
    return site.body.face_touched(site.index, face) ? 1.0 : -1.0;
}

// Returns a point slightly inside the middle of the face.
Vec3 contact_spot(std::size_t channel, int handedness) {
    constexpr double kShare = 0.8;
    switch (face_of(channel, handedness)) {
        case Face::kDistal:
            return {kShare, 0.0, 0.0};
        case Face::kLeft:
            return {0.0, kShare, 0.0};
        case Face::kProximal:
            return {-kShare, 0.0, 0.0};
        case Face::kRight:
        case Face::kFront:
        case Face::kBack:
            break;
    }
    return {0.0, -kShare, 0.0};
}

// Front and back, which are exchanged where depth is mirrored.
Face flat_face_of(std::size_t channel, const Mirror& mirror) {
    return (channel == 0) == (mirror.depth > 0) ? Face::kFront : Face::kBack;
}

double read_flat_contact(const SensorSite& site, double& /*memory*/) {
    const Face face = flat_face_of(site.channel, site.mirror);
    return site.body.face_touched(site.index, face) ? 1.0 : -1.0;
}

double read_load(const SensorSite& site, double& /*memory*/) {
    return limited_reading(site.body.part_load(site.index) / (site.body.mass() * kEarthGravity));
}

}  // namespace

// Contact of each face of a part with the ground or another part: +1 for contact, -1 for none (Sims
// 1994).
void add_contact_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "contact",
                 .label = "Contact",
                 .group = "Joint and touch",
                 .channels = {{"contact-distal", "Contact, far end"},
                              {"contact-left", "Contact, left"},
                              {"contact-proximal", "Contact, near end"},
                              {"contact-right", "Contact, right"}},
                 .read = read_contact,
                 .spot = contact_spot});
}

// The same of the two faces that parts have in space only.
void add_flat_contact_sensor(SensorRegistry& sensors) {
    sensors.add(
        {.id = "flat-contact",
         .label = "Contact, front and back",
         .group = "Joint and touch",
         .channels = {{"contact-front", "Contact, front"}, {"contact-back", "Contact, back"}},
         .read = read_flat_contact});
}

// Load: the sum of the normal forces on the part, in units of the creature's weight on Earth.
void add_load_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "load",
                 .label = "Load",
                 .group = "Strength of touch",
                 .channels = {{"load", "Load"}},
                 .read = read_load,
                 .spot = [](std::size_t, int) { return Vec3(0.6, 0.0, 0.0); },
                 .reads_forces = true,
                 .usual = false});
}

}  // namespace cambrian
