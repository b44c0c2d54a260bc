#include "dynamics/contact.h"

#include <cmath>

namespace cambrian {

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

}  // namespace cambrian
