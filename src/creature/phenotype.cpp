#include "creature/phenotype.h"

#include "core/assert.h"
#include "creature/morphogenesis.h"
#include "creature/wiring.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

double Phenotype::mass(double density) const {
    double size = 0.0;  // m^2, or m^3 in space
    for (const BodyPart& part : parts) {
        const double area = part.length * part.width;
        size += part.thickness > 0.0 ? area * part.thickness : area;
    }
    return density * size;
}

bool Phenotype::can_move() const {
    return !effectors.empty() || deformers() > 0;
}

std::size_t Phenotype::deformers() const {
    return static_cast<std::size_t>(std::count_if(
        organs.begin(), organs.end(), [](const GrownOrgan& organ) { return organ.deforms; }));
}

double Phenotype::rest_length() const {
    std::vector<Vec3> corners;
    for (const PlannedPart& part : plan.parts) {
        for (const double x : {-part.half_extents.x(), part.half_extents.x()}) {
            for (const double y : {-part.half_extents.y(), part.half_extents.y()}) {
                const double z = part.half_extents.z();
                corners.push_back(transform(part.rest_pose, Vec3(x, y, z)));
                if (z > 0.0) corners.push_back(transform(part.rest_pose, Vec3(x, y, -z)));
            }
        }
    }
    double greatest = 0.0;  // m^2
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            greatest = std::fmax(greatest, (corners[i] - corners[j]).squaredNorm());
    }
    return std::sqrt(greatest);
}

Phenotype express(const Genome& genome, const Kinds& kinds, const ExpressionSettings& settings,
                  const SceneSettings& scene, Side side) {
    CAMBRIAN_ASSERT(!genome.nodes.empty(), "a valid genome has a root");
    Phenotype phenotype;
    grow(genome, kinds, settings, scene, side, phenotype);
    CAMBRIAN_TICK_ASSERT(phenotype.parts.size() == phenotype.plan.parts.size(), "a body a part");
    CAMBRIAN_TICK_ASSERT(
        phenotype.parts.size() <= static_cast<std::size_t>(std::max(settings.max_parts, 1)),
        "parts have room");
    wire(genome, kinds, phenotype);
    return phenotype;
}

}  // namespace cambrian
