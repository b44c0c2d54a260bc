#pragma once

// The starred creatures that panels see, and the requests they may make of all generations.

#include "evolution/engine/snapshot.h"
#include "studio/viewer/stars.h"

#include <cstdint>
#include <variant>

namespace cambrian {

// Displays the champion of a generation.
struct ShowChampion {
    std::uint32_t generation = 0;
};
// Displays a creature of any generation in the world that evaluated it.
struct ShowIndividual {
    JudgedIndividual creature;
};
// Displays the newest champion now and after each further generation.
struct ShowNewest {};
struct ToggleStar {
    JudgedIndividual creature;
};
struct ToggleStarOfShown {};
// Restores the star that was removed last.
struct RestoreStar {};

using GenerationsRequest = std::variant<ShowChampion, ShowIndividual, ShowNewest, ToggleStar,
                                        ToggleStarOfShown, RestoreStar>;

struct GenerationsView {
    const Stars& stars;
};

}  // namespace cambrian
