#include "render/solid_instances.h"

#include <algorithm>

namespace cambrian {

void list_boxes(const SpaceFrame& frame, ShadingBoxes& boxes) {
    boxes.solids.clear();
    boxes.numbers.clear();
    const Vec3 sun = frame.light.direction.normalized();
    for (std::size_t i = 0; i < frame.solids.size() && boxes.solids.size() < kMostShading; ++i) {
        const Solid& solid = frame.solids[i];
        if (!solid.shadows || solid.fill.a < 1.0F) continue;
        boxes.solids.push_back(i);
        const auto turn = solid.pose.orientation.toRotationMatrix();
        const Floats3 at = floats(solid.pose.position - frame.camera.target);
        for (int axis = 0; axis < 3; ++axis) {
            for (const float number : floats(turn.col(axis)))
                boxes.numbers.push_back(number);
            boxes.numbers.push_back(at[static_cast<std::size_t>(axis)]);
        }
        const Vec3 light = turn.transpose() * sun;
        const auto inverse = [](double share) {
            constexpr double kLeast = 1e-6;
            return 1.0 / (share < 0.0 ? std::min(share, -kLeast) : std::max(share, kLeast));
        };
        for (const Vec3& three : {solid.half_extents, Vec3(light.unaryExpr(inverse))}) {
            for (const float number : floats(three))
                boxes.numbers.push_back(number);
            boxes.numbers.push_back(0.0F);
        }
    }
}

namespace {

// Returns the places of the wanted solids in the frame, in the order in which they are drawn.
std::vector<std::size_t> solids_in_order(const SpaceFrame& frame, SolidsWanted wanted, bool inked) {
    const bool opaque = wanted == SolidsWanted::kOpaque;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        const Solid& solid = frame.solids[i];
        if ((solid.fill.a >= 1.0F) == opaque && solid.inked == inked) order.push_back(i);
    }
    const auto nearness = [&frame](std::size_t solid) {
        return (frame.solids[solid].pose.position - frame.camera.target).dot(frame.camera.back);
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return opaque ? nearness(a) > nearness(b) : nearness(a) < nearness(b);
    });
    return order;
}

}  // namespace

std::vector<SolidInstance> instances_of(const SpaceFrame& frame, const ShadingBoxes& shading,
                                        SolidsWanted wanted, bool inked) {
    std::vector<SolidInstance> instances;
    const Vec3 sun = frame.light.direction.normalized();
    struct Neighbour {
        double away;
        std::size_t box;
    };
    std::vector<Neighbour> neighbours;
    for (const std::size_t i : solids_in_order(frame, wanted, inked)) {
        const Solid& solid = frame.solids[i];
        SolidInstance instance{};
        const auto turn = solid.pose.orientation.toRotationMatrix();
        const Floats3 at = floats(solid.pose.position - frame.camera.target);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats3 column = floats(turn.col(static_cast<int>(axis)));
            std::copy(column.begin(), column.end(), instance.axes.begin() + 4 * axis);
            instance.axes[4 * axis + 3] = at[axis];
        }
        const Floats3 half = floats(solid.half_extents);
        instance.size = {half[0], half[1], half[2], static_cast<float>(solid.radius)};
        instance.fill = {solid.fill.r, solid.fill.g, solid.fill.b, solid.fill.a};
        instance.look = {static_cast<float>(solid.pattern), static_cast<float>(1.0 / solid.wave),
                         solid.phase, solid.gleams ? 1.0F : 0.0F};
        // The boxes that may lie between it and the sun, or beside it, the nearest first.
        neighbours.clear();
        const double own = solid.half_extents.norm();
        for (std::size_t box = 0; box < shading.solids.size(); ++box) {
            const Solid& other = frame.solids[shading.solids[box]];
            if (shading.solids[box] == i) continue;
            const Vec3 way = other.pose.position - solid.pose.position;
            const double along = way.dot(sun);
            const double aside = along > 0.0 ? (way - along * sun).norm() : way.norm();
            const double gap = aside - own - other.half_extents.norm();
            if (gap < 0.05) neighbours.push_back({gap, box});
        }
        std::stable_sort(neighbours.begin(), neighbours.end(),
                         [](const Neighbour& a, const Neighbour& b) { return a.away < b.away; });
        for (std::size_t k = 0; k < kBesideSolid; ++k)
            instance.beside[k] =
                k < neighbours.size() ? static_cast<float>(neighbours[k].box) : -1.0F;
        instances.push_back(instance);
    }
    return instances;
}

}  // namespace cambrian
