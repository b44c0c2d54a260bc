#include "dynamics/part_places.h"

namespace cambrian {

void place_parts(const PlanarModel& model, const Kinematics& k, PartPlaces& places) {
    for (int part = 0; part < model.part_count; ++part) {
        const int b = model.part_body[part];
        const double cosine = k.cosine[b];
        const double sine = k.sine[b];
        places.x[part] = k.x[b] + cosine * model.part_x[part] - sine * model.part_y[part];
        places.y[part] = k.y[b] + sine * model.part_x[part] + cosine * model.part_y[part];
        places.axis_x[part] = cosine * model.part_cosine[part] - sine * model.part_sine[part];
        places.axis_y[part] = sine * model.part_cosine[part] + cosine * model.part_sine[part];
    }
}

}  // namespace cambrian
