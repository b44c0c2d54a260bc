#include "dynamics/contact/swept_boxes.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Returns the smaller sides of four boxes, at the end where they are smaller.
CAMBRIAN_INLINE Simd4d smaller_sides(const BoxEnds& ends, int first) {
    const auto at = [&](const PartPlaces& places) {
        return lesser(load_lanes(places.half_length + first),
                      load_lanes(places.half_width + first));
    };
    return 2.0 * (ends.model.stretch_count > 0 ? lesser(at(ends.from), at(ends.to)) : at(ends.to));
}

}  // namespace

void find_sides(const BoxEnds& ends, BoxSides& sides) {
    CAMBRIAN_TICK_ASSERT(ends.model.part_count > 0, "a body has a box");
    Simd4d thinnest = all_lanes(1e9);
    for (int first = 0; first < ends.model.part_count; first += kLanes) {
        const Simd4d thin = smaller_sides(ends, first);
        store_lanes(sides.thin + first, thin);
        thinnest = lesser(thinnest, thin > Simd4d{} ? thin : thinnest);  // slots beyond are 0
    }
    sides.thinnest = -largest_of(-thinnest);
}

void find_travels(const BoxEnds& ends, const PerBody& from_angle, const PerBody& to_angle,
                  BoxTravels& travels) {
    const PlanarModel& model = ends.model;
    const bool deforms = model.stretch_count > 0;
    const double x = ends.to.x[0] - ends.from.x[0];
    const double y = ends.to.y[0] - ends.from.y[0];
    Simd4d farthest = {};  // beside box 0
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        const Simd4d turn = gather(to_angle, bodies) - gather(from_angle, bodies);
        Simd4d swing = load_lanes(model.radius + first) * magnitude(turn);
        if (deforms) swing += growths_of(ends, first);
        store_lanes(travels.turn + first, turn);
        store_lanes(travels.swing + first, swing);
        const Simd4d move_x = load_lanes(ends.to.x + first) - load_lanes(ends.from.x + first) - x;
        const Simd4d move_y = load_lanes(ends.to.y + first) - load_lanes(ends.from.y + first) - y;
        const Simd4d beside = most_length(move_x, move_y) + swing;
        store_lanes(travels.beside + first, beside);
        farthest = greater(farthest, beside);
    }
    travels.most_past = 2.0 * largest_of(farthest);
}

double travel_of(const BoxEnds& ends, const BoxTravels& travels, int part) {
    const double x = ends.to.x[part] - ends.from.x[part];
    const double y = ends.to.y[part] - ends.from.y[part];
    return std::sqrt(x * x + y * y) + travels.swing[part];
}

}  // namespace cambrian
