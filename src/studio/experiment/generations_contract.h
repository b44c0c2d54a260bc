#pragma once

// What panels see of starred creatures and what they may request of past and present generations.

#include "evolution/engine/snapshot.h"
#include "studio/viewer/stars.h"

#include <cstdint>
#include <variant>

namespace cambrian {

// Displays the champion of a generation.
struct ShowChampion {
    std::uint32_t generation = 0;
};
// Displays a creature of some generation, under the settings that judged it.
struct ShowIndividual {
    JudgedIndividual creature;
};
// Displays the newest champion, and each that follows.
struct ShowNewest {};
struct ToggleStar {
    JudgedIndividual creature;
};
struct ToggleStarOfShown {};
// Gives back the star that was taken away last.
struct RestoreStar {};

using GenerationsRequest = std::variant<ShowChampion, ShowIndividual, ShowNewest, ToggleStar,
                                        ToggleStarOfShown, RestoreStar>;

struct GenerationsView {
    const Stars& stars;
};

}  // namespace cambrian
