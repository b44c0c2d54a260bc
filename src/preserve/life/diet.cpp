#include "preserve/life/diet.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kDietWithoutMouth = 0.25;

// Specialists digest all, the omnivore 5/8 of each.
double digested(double x) {
    return x + 0.125 * (1.0 - std::fabs(2.0 * x - 1.0));
}

}  // namespace

std::vector<Mouth> mouths_of(const Phenotype& phenotype, const OrganRegistry& organs) {
    std::vector<Mouth> mouths;
    for (const GrownOrgan& organ : phenotype.organs) {
        if (!organs[organ.kind].eats) continue;
        mouths.push_back({organ.part, organ.parameters.front(), phenotype.parts[organ.part].width});
    }
    mouths.shrink_to_fit();
    if (mouths.empty()) mouths.push_back({0, kDietWithoutMouth, phenotype.parts.front().width});
    return mouths;
}

double share_of_plants(double diet) {
    return digested(1.0 - diet);
}

double share_of_flesh(double diet) {
    return digested(diet);
}

}  // namespace cambrian
