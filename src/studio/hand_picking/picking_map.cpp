#include "studio/hand_picking/picking_map.h"

namespace cambrian {

std::vector<MapPlace> lay_out_map(const PickingTree& tree) {
    std::vector<MapPlace> places(tree.size());
    std::vector<bool> goes_on(tree.size(), false);
    int last_row = 0;
    for (std::uint32_t number = 0; number < tree.size(); ++number) {
        const std::optional<std::uint32_t> parent = tree.node(number).parent;
        if (!parent) continue;
        places[number].column = places[*parent].column + 1;
        places[number].row = goes_on[*parent] ? ++last_row : places[*parent].row;
        goes_on[*parent] = true;
    }
    return places;
}

}  // namespace cambrian
