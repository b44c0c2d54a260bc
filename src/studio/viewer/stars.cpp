#include "studio/viewer/stars.h"

#include <algorithm>

namespace cambrian {
namespace {

// Compares genomes, since a survivor of a later generation shares its genome with the starred one.
auto find_in(const std::vector<JudgedIndividual>& creatures, const Individual& individual) {
    return std::find_if(creatures.begin(), creatures.end(), [&](const JudgedIndividual& each) {
        return each.individual->genome == individual.genome;
    });
}

}  // namespace

bool Stars::has(const Individual& individual) const {
    return find_in(all_, individual) != all_.end();
}

void Stars::toggle(const JudgedIndividual& creature) {
    ++revision_;
    const auto found = find_in(all_, *creature.individual);
    if (found == all_.end()) {
        all_.push_back(creature);
        return;
    }
    taken_.push_back(*found);
    all_.erase(found);
}

void Stars::restore() {
    if (taken_.empty()) return;
    const JudgedIndividual creature = taken_.back();
    taken_.pop_back();
    if (!has(*creature.individual)) toggle(creature);
}

void Stars::replace(std::vector<JudgedIndividual> all) {
    all_ = std::move(all);
    taken_.clear();
    ++revision_;
}

}  // namespace cambrian
