#pragma once

#include "evolution/generation.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <memory>
#include <vector>

namespace cambrian::test {

inline SettingsPtr default_settings() {
    return std::make_shared<const ExperimentSettings>();
}

// Returns a creature of two parts: a body and a leg that swings.
inline GenomePtr hopper() {
    CreatureBuilder builder(kinds().creature.catalog);
    const auto body = builder.part(0.6, 0.2);
    const auto leg = builder.part(0.4, 0.12);
    builder.attach(body, leg, 0.125, -0.6);
    builder.swing(leg, 1.0, 0.0, 1.0);
    return builder.build();
}

// Returns random creatures that are not evaluated.
inline std::vector<IndividualPtr> strangers(std::size_t count, std::uint64_t seed = 1) {
    ExperimentSettings settings;
    settings.seed = seed;
    std::vector<IndividualPtr> all;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(make_immigrant(settings, kinds(), 0, i));
    return all;
}

}  // namespace cambrian::test
