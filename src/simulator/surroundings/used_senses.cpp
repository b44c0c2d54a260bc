#include "simulator/surroundings/used_senses.h"

namespace cambrian {

UsedSenses senses_of(const Phenotype& phenotype, const Kinds& kinds) {
    UsedSenses used;
    for (const GrownOrgan& organ : phenotype.organs) {
        const OrganKind& kind = kinds.organs[organ.kind];
        used.scents |= kind.scents;
        used.voices += kind.sounds ? 1 : 0;
    }
    for (const WiredSensor& sensor : phenotype.sensors) {
        const SensorKind& kind = kinds.sensors[sensor.kind];
        used.smells |= kind.smells;
        used.feels_ground |= kind.feels_ground;
    }
    return used;
}

}  // namespace cambrian
