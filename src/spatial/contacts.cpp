#include "spatial/contacts.h"

#include "spatial/ground_contacts.h"
#include "spatial/self_contacts.h"

namespace cambrian::spatial {

void ContactSet::add(const Contact& contact) {
    if (count < most) {
        items[count++] = contact;
        return;
    }
    Contact* farthest = items;
    for (int c = 1; c < count; ++c) {
        if (items[c].gap > farthest->gap) farthest = items + c;
    }
    if (contact.gap >= farthest->gap) return;
    std::copy(farthest + 1, items + count, farthest);
    items[count - 1] = contact;
}

double ContactSet::depth() const {
    double deepest = 0.0;
    for (int c = 0; c < count; ++c)
        deepest = std::max(deepest, -items[c].gap);
    return deepest;
}

void detect_contacts(const Model& model, bool has_ground, const Motion& motion,
                     const Kinematics& kinematics, ContactSet& contacts) {
    contacts.count = 0;
    contacts.most = most_contacts(model);
    if (has_ground) add_ground_contacts(model, motion, kinematics, contacts);
    if (model.pair_count > 0) add_self_contacts(model, kinematics, contacts);
}

}  // namespace cambrian::spatial
