#include "evolution/selections/selection.h"

namespace cambrian {

void add_truncation(SelectionRegistry& selections);
void add_rank(SelectionRegistry& selections);
void add_tournament(SelectionRegistry& selections);
void add_roulette(SelectionRegistry& selections);
void add_map_elites(SelectionRegistry& selections);
void add_novelty(SelectionRegistry& selections);
void add_age_protection(SelectionRegistry& selections);

SelectionRegistry builtin_selections() {
    SelectionRegistry selections;
    add_truncation(selections);
    add_rank(selections);
    add_tournament(selections);
    add_roulette(selections);
    add_map_elites(selections);
    add_novelty(selections);
    add_age_protection(selections);
    return selections;
}

}  // namespace cambrian
