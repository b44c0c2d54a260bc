#include "simulator/passive_sink.h"

#include "genome/gene.h"

#include <cmath>

namespace cambrian {

// k1 v + k2 v^2 = weight of a metre of the part
double passive_sink(const Environment& environment) {
    const double weight = environment.density * gene_range::kMinSize * environment.gravity;
    const double linear = environment.viscosity_linear;
    const double quadratic = environment.viscosity_quadratic;
    const double root = std::sqrt(linear * linear + 4.0 * quadratic * weight);
    if (!(linear + root > 0.0)) return 0.0;
    return 2.0 * weight / (linear + root);
}

}  // namespace cambrian
