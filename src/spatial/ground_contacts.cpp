#include "spatial/ground_contacts.h"

#include <algorithm>
#include <cmath>

namespace cambrian::spatial {
namespace {

// The heights of a part's centre, and how much of each half extent is vertical.
struct Heights {
    double center = 0.0;
    double rise[3] = {};

    double lowest() const {
        return center - (std::fabs(rise[0]) + std::fabs(rise[1]) + std::fabs(rise[2]));
    }
    double corner(int number) const {
        double height = center;
        for (int a = 0; a < 3; ++a)
            height += (number >> a & 1) != 0 ? rise[a] : -rise[a];
        return height;
    }
};

Heights heights_of(const Part& part, const Kinematics& k, double center) {
    const Turn& turn = k.turn[part.body];
    const Vec3 up(turn.axis[0].y(), turn.axis[1].y(), turn.axis[2].y());
    Heights heights{center + k.place[part.body].y() + dot(up, part.place)};
    for (int a = 0; a < 3; ++a)
        heights.rise[a] = part.half[a] * dot(up, part.turn.axis[a]);
    return heights;
}

Vec3 corner_of(const Part& part, int number) {
    Vec3 point = part.place;
    for (int a = 0; a < 3; ++a)
        point += ((number >> a & 1) != 0 ? part.half[a] : -part.half[a]) * part.turn.axis[a];
    return point;
}

}  // namespace

void add_ground_contacts(const Model& model, const Motion& motion, const Kinematics& k,
                         ContactSet& contacts) {
    const double center = motion.position[model.place() + 1];
    const Vec3 drift = coordinate_vector(motion.speed + model.place());
    for (int p = 0; p < model.part_count; ++p) {
        const Part& part = model.parts[p];
        const Heights heights = heights_of(part, k, center);
        if (heights.lowest() >= kContactMargin) continue;
        const int b = part.body;
        for (int corner = 0; corner < kCorners; ++corner) {
            const double gap = heights.corner(corner);
            if (gap >= kContactMargin) continue;
            const Vec3 point = corner_of(part, corner);
            const Vec3 velocity = k.velocity[b] + cross(k.spin[b], k.turn[b] * point) + drift;
            contacts.add({.id = p * kCorners + corner,
                          .body = b,
                          .part = p,
                          .point = point,
                          .gap = gap,
                          .rate = {velocity.y(), velocity.x(), velocity.z()}});
        }
    }
}

double lowest_corner(const Model& model, const Motion& motion, const Kinematics& k) {
    const double center = motion.position[model.place() + 1];
    double lowest = heights_of(model.parts[0], k, center).lowest();
    for (int p = 1; p < model.part_count; ++p)
        lowest = std::min(lowest, heights_of(model.parts[p], k, center).lowest());
    return lowest;
}

}  // namespace cambrian::spatial
