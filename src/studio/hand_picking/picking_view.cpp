#include "studio/hand_picking/picking_view.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "studio/viewer/mutation_words.h"
#include "studio/viewer/origin_words.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::size_t kMostChanges = 6;  // lines

}  // namespace

int grid_columns(int cells) {
    int columns = 1;
    while (columns * columns < cells)
        ++columns;
    return columns;
}

int pick_number(const PickingSnapshot& snapshot, std::size_t cell) {
    const auto found = std::find(snapshot.picks.begin(), snapshot.picks.end(), cell);
    return found == snapshot.picks.end() ? 0 : static_cast<int>(found - snapshot.picks.begin()) + 1;
}

std::string picking_words(const PickingSnapshot& snapshot) {
    if (!snapshot.message.empty()) return capitalized(snapshot.message);
    if (snapshot.status == PickingStatus::kEvolving) {
        return fmt::format("Evolving: {} of {} generations", snapshot.generations_done,
                           snapshot.generations_asked);
    }
    if (snapshot.tree.empty()) return "Making the first grid";
    if (deciding(snapshot)) return "Breeding the next grid";
    if (snapshot.picks.empty()) return "Click the creatures you like";
    return snapshot.children_ready ? "Enter breeds; the children are ready" : "Enter breeds";
}

std::string origin_words(const GridNode& node) {
    const std::string picks = counted(node.picks.size(), "pick");
    switch (node.origin) {
        case GridOrigin::kPopulation:
            return "chosen from the population";
        case GridOrigin::kCreatures:
            return "begun from a creature";
        case GridOrigin::kBreeding:
            return "bred from " + picks;
        case GridOrigin::kImmigrants:
            return "random creatures beside " + picks;
        case GridOrigin::kAssistance:
            return fmt::format("evolved for {} generations from {}", node.generations, picks);
        case GridOrigin::kShelf:
            break;
    }
    return "with a creature from the shelf";
}

std::string change_words(const Individual& creature, const EvolutionKinds& kinds) {
    std::string words = method_words(creature.method, kinds);
    const std::size_t shown = std::min(creature.mutations.size(), kMostChanges);
    for (std::size_t i = 0; i < shown; ++i)
        words += "\n" + mutation_words(creature.mutations[i], kinds.mutations);
    if (shown < creature.mutations.size())
        words += fmt::format("\nand {} more", creature.mutations.size() - shown);
    return words;
}

}  // namespace cambrian
