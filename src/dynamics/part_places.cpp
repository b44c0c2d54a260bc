#include "dynamics/part_places.h"

namespace cambrian {

CAMBRIAN_WIDE void place_parts(const PlanarModel& model, const Kinematics& k, PartPlaces& places) {
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        const Lanes cosine = gather(k.cosine, bodies);
        const Lanes sine = gather(k.sine, bodies);
        const Lanes part_x = load_lanes(model.part_x + first);
        const Lanes part_y = load_lanes(model.part_y + first);
        const Lanes part_cosine = load_lanes(model.part_cosine + first);
        const Lanes part_sine = load_lanes(model.part_sine + first);
        store_lanes(places.x + first, gather(k.x, bodies) + cosine * part_x - sine * part_y);
        store_lanes(places.y + first, gather(k.y, bodies) + sine * part_x + cosine * part_y);
        store_lanes(places.axis_x + first, cosine * part_cosine - sine * part_sine);
        store_lanes(places.axis_y + first, sine * part_cosine + cosine * part_sine);
    }
}

}  // namespace cambrian
