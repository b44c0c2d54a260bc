#include "preserve/chronicle.h"

#include <iterator>
#include <utility>

namespace cambrian {
namespace {

template <class Item>
void move_to(std::vector<Item>& to, std::vector<Item>& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

void append(Chronicle& all, Chronicle later) {
    move_to(all.born, later.born);
    move_to(all.died, later.died);
    move_to(all.series, later.series);
    move_to(all.interventions, later.interventions);
    move_to(all.museum, later.museum);
    if (later.snapshot) all.snapshot = std::move(later.snapshot);
}

}  // namespace cambrian
