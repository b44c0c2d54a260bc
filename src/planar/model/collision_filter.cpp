#include "planar/model/collision_filter.h"

#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kRestClearance = 0.01;  // m

struct RestBox {
    double x, y, cosine, sine, half_length, half_width;
};

RestBox rest_box(const PlannedPart& part) {
    const SineCosine turn = sine_cosine(part.rest_angle);
    return {part.rest_pose.position.x(), part.rest_pose.position.y(), turn.cosine, turn.sine,
            part.half_extents.x(),       part.half_extents.y()};
}

// Returns the largest gap between the two along the axes of box a; negative if they overlap on
// both.
double gap_along_axes(const RestBox& a, const RestBox& b) {
    const double along = std::fabs(a.cosine * b.cosine + a.sine * b.sine);
    const double across = std::fabs(a.cosine * b.sine - a.sine * b.cosine);
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double gap_x = std::fabs(a.cosine * x + a.sine * y) - a.half_length -
                         along * b.half_length - across * b.half_width;
    const double gap_y = std::fabs(a.cosine * y - a.sine * x) - a.half_width -
                         across * b.half_length - along * b.half_width;
    return std::max(gap_x, gap_y);
}

bool share_joint(const PlanarModel& model, int a, int b) {
    return model.parent[a] == b || model.parent[b] == a;
}

}  // namespace

std::vector<PartPair> find_colliding_pairs(const PlanarModel& model, const BodyPlan& plan) {
    RestBox boxes[kMaxParts];
    for (int i = 0; i < model.part_count; ++i)
        boxes[i] = rest_box(plan.parts[static_cast<std::size_t>(i)]);
    std::vector<PartPair> pairs;
    for (int i = 0; i < model.part_count; ++i) {
        for (int j = i + 1; j < model.part_count; ++j) {
            const int a = model.part_body[i];
            const int b = model.part_body[j];
            if (a == b || share_joint(model, a, b)) continue;
            const double gap =
                std::max(gap_along_axes(boxes[i], boxes[j]), gap_along_axes(boxes[j], boxes[i]));
            if (gap < kRestClearance) continue;
            pairs.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)});
        }
    }
    return pairs;
}

}  // namespace cambrian
