#include "simulator/surroundings/used_senses.h"

namespace cambrian {

UsedSenses senses_of(const Phenotype& phenotype, const Kinds& kinds) {
    UsedSenses used{.voices = phenotype.organs.size()};
    for (const GrownOrgan& organ : phenotype.organs)
        used.scents |= kinds.organs[organ.kind].scents;
    for (const WiredSensor& sensor : phenotype.sensors) {
        used.hears |= kinds.sensors[sensor.kind].hears;
        used.smells |= kinds.sensors[sensor.kind].smells;
    }
    return used;
}

}  // namespace cambrian
