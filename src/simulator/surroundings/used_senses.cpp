#include "simulator/surroundings/used_senses.h"

namespace cambrian {

UsedSenses senses_of(const Phenotype& phenotype, const Kinds& kinds) {
    UsedSenses used;
    for (const GrownOrgan& organ : phenotype.organs) {
        const OrganKind& kind = kinds.organs[organ.kind];
        used.scents |= kind.scents;
        used.voices += kind.sounds ? 1 : 0;
    }
    for (const WiredSensor& sensor : phenotype.sensors)
        used.smells |= kinds.sensors[sensor.kind].smells;
    return used;
}

}  // namespace cambrian
