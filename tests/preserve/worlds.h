#pragma once

// Small preserves for tests.

#include "evolution/fields/setting_field.h"
#include "preserve/preserve.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <memory>
#include <utility>
#include <vector>

namespace cambrian::test {

inline ExperimentSettings small_world() {
    ExperimentSettings settings = preserve_defaults(kinds());
    settings.preserve.bodies = "ghostly";
    settings.preserve.width = 12.0;
    settings.preserve.height = 10.0;
    settings.preserve.founders = 10;
    settings.preserve.energy_density = 100.0;
    return settings;
}

// Returns a fish whose head is a mouth with that diet.
inline GenomePtr eater(double diet, double width = 0.2) {
    CreatureBuilder builder(kind_catalog());
    const auto head = builder.part(0.4, width);
    const auto tail = builder.part(0.5, 0.15);
    builder.attach(head, tail, 0.625);
    builder.swing(tail, 1.0, 0.0, 0.6);
    builder.organ(head, "mouth", 0, 0.0, diet);
    return builder.build();
}

inline std::unique_ptr<Preserve> begun(const ExperimentSettings& settings,
                                       std::vector<GenomePtr> founders) {
    auto preserve = Preserve::begin(std::make_shared<const ExperimentSettings>(settings), kinds(),
                                    std::move(founders));
    INFO((preserve ? "" : preserve.error().message));
    REQUIRE(preserve);
    return std::move(*preserve);
}

inline void run_to(Preserve& preserve, std::uint64_t tick) {
    ThreadPool pool(1);
    while (preserve.ticks() < tick)
        preserve.tick(pool);
}

inline std::uint64_t digest(const Preserve& preserve) {
    return digest_of(words_of(preserve.save()));
}

}  // namespace cambrian::test
