#include "spatial/self_contacts.h"

#include "spatial/box_contacts.h"
#include "spatial/ground_contacts.h"

namespace cambrian::spatial {
namespace {

constexpr double kLeastRestGap = 0.01;  // m

PlacedBox placed_part(const Model& model, const Kinematics& k, int number) {
    const Part& part = model.parts[number];
    const Turn& turn = k.turn[part.body];
    return {k.place[part.body] + turn * part.place, turn * part.turn, part.half};
}

// Adds the points of a pair of parts.
void add_pair_points(const Model& model, const Kinematics& k, int pair, const BoxManifold& manifold,
                     ContactSet& contacts) {
    const int first = model.pairs[pair].first;
    const int second = model.pairs[pair].second;
    Contact contact;
    contact.part = manifold.first_is_incident ? first : second;
    contact.other_part = manifold.first_is_incident ? second : first;
    contact.body = model.parts[contact.part].body;
    contact.other_body = model.parts[contact.other_part].body;
    const int a = contact.body;
    const int b = contact.other_body;
    contact.surface = k.turn[b].back(manifold.surface);
    for (int p = 0; p < manifold.count; ++p) {
        const BoxPoint& point = manifold.points[p];
        const Vec3 arm = point.place - k.place[a];
        const Vec3 velocity = k.velocity[a] + cross(k.spin[a], arm) - k.velocity[b] -
                              cross(k.spin[b], point.place - k.place[b]);
        contact.id = kGroundContacts + pair * kBoxFeatures + point.feature;
        contact.point = k.turn[a].back(arm);
        contact.gap = point.gap;
        contact.rate = manifold.surface.back(velocity);
        contacts.add(contact);
    }
}

}  // namespace

void let_parts_touch(Model& model, bool touch) {
    model.pair_count = 0;
    if (!touch) return;
    Kinematics k;
    compute_kinematics(model, rest_motion(model), k);
    for (int i = 0; i < model.part_count; ++i) {
        const PlacedBox first = placed_part(model, k, i);
        for (int j = i + 1; j < model.part_count; ++j) {
            const int a = model.parts[i].body;
            const int b = model.parts[j].body;
            if (a == b || model.bodies[a].parent == b || model.bodies[b].parent == a) continue;
            if (gap_between(first, placed_part(model, k, j)) < kLeastRestGap) continue;
            model.pairs[model.pair_count++] = {static_cast<std::uint8_t>(i),
                                               static_cast<std::uint8_t>(j)};
        }
    }
}

void add_self_contacts(const Model& model, const Kinematics& k, ContactSet& contacts) {
    PlacedBox boxes[kMostParts];
    for (int p = 0; p < model.part_count; ++p)
        boxes[p] = placed_part(model, k, p);
    for (int pair = 0; pair < model.pair_count; ++pair) {
        const int i = model.pairs[pair].first;
        const int j = model.pairs[pair].second;
        const Vec3 way = boxes[j].center - boxes[i].center;
        const double reach = model.parts[i].radius + model.parts[j].radius + kContactMargin;
        if (dot(way, way) >= reach * reach) continue;
        const BoxManifold manifold = collide_boxes(boxes[i], boxes[j], kContactMargin);
        if (manifold.count > 0) add_pair_points(model, k, pair, manifold, contacts);
    }
}

}  // namespace cambrian::spatial
