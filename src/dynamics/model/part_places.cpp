#include "dynamics/model/part_places.h"

namespace cambrian {

namespace {

// If every body is one box, positions of boxes are those of bodies.
CAMBRIAN_INLINE void place_single_boxes(const PlanarModel& model, const Kinematics& k,
                                        PartPlaces& places) {
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        store_lanes(places.x + first, gather(k.x, bodies));
        store_lanes(places.y + first, gather(k.y, bodies));
        store_lanes(places.axis_x + first, gather(k.cosine, bodies));
        store_lanes(places.axis_y + first, gather(k.sine, bodies));
    }
}

// Sets the present half extents.
CAMBRIAN_INLINE void size_parts(const PlanarModel& model, const Kinematics& k, PartPlaces& places) {
    use_sizes(model, places);
    if (model.stretch_count == 0) return;
    for (int part = 0; part < round_up_to_lanes(model.part_count); ++part) {
        const int b = model.part_body[part];
        places.stretched_length[part] = k.length_growth[b] * model.half_length[part];
        places.stretched_width[part] = k.width_growth[b] * model.half_width[part];
    }
}

}  // namespace

void place_parts(const PlanarModel& model, const Kinematics& k, PartPlaces& places) {
    size_parts(model, k, places);
    if (has_single_boxes(model)) return place_single_boxes(model, k, places);
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        const PartLanes parts = part_lanes(model, k, first);
        const Simd4dVector& offset = parts.offset;
        const Simd4dVector axis = part_axes(model, parts, first);
        store_lanes(places.x + first,
                    gather(k.x, bodies) + parts.cosine * offset.x - parts.sine * offset.y);
        store_lanes(places.y + first,
                    gather(k.y, bodies) + parts.sine * offset.x + parts.cosine * offset.y);
        store_lanes(places.axis_x + first, axis.x);
        store_lanes(places.axis_y + first, axis.y);
    }
}

}  // namespace cambrian
