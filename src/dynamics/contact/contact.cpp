#include "dynamics/contact/contact.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

Contact* ContactSet::drop_farthest(double gap) {
    CAMBRIAN_TICK_ASSERT(count == most, "there is no room");
    int farthest = 0;
    for (int i = 1; i < count; ++i) {
        if (items[i].gap > items[farthest].gap) farthest = i;
    }
    if (gap >= items[farthest].gap) return nullptr;
    std::copy(items + farthest + 1, items + count, items + farthest);
    return &items[count - 1];
}

Face face_toward(double x, double y) {
    if (std::fabs(x) >= std::fabs(y)) return x > 0.0 ? Face::kDistal : Face::kProximal;
    return y > 0.0 ? Face::kLeft : Face::kRight;
}

}  // namespace cambrian
