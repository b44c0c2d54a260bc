#include "evolution/selections/selection.h"

namespace cambrian {

void register_truncation(SelectionRegistry& selections);
void register_rank(SelectionRegistry& selections);
void register_tournament(SelectionRegistry& selections);
void register_roulette(SelectionRegistry& selections);
void register_map_elites(SelectionRegistry& selections);
void register_novelty(SelectionRegistry& selections);
void register_age_protection(SelectionRegistry& selections);

SelectionRegistry builtin_selections() {
    SelectionRegistry selections;
    register_truncation(selections);
    register_rank(selections);
    register_tournament(selections);
    register_roulette(selections);
    register_map_elites(selections);
    register_novelty(selections);
    register_age_protection(selections);
    return selections;
}

}  // namespace cambrian
