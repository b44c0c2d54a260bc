#pragma once

// The opponents of a contest, one for each trial.

#include "creature/phenotype.h"
#include "genome/genome.h"

#include <algorithm>
#include <vector>

namespace cambrian {

struct Opponents {
    std::vector<GenomePtr> genomes;  // none is null

    // Returns the opponent of a trial, or null if there are none.
    GenomePtr of_trial(int trial) const {
        if (genomes.empty()) return nullptr;
        return genomes[static_cast<std::size_t>(trial) % genomes.size()];
    }

    // Returns the hue of the lineage of a trial's opponent, in turns.
    double hue_of_trial(int trial) const {
        const GenomePtr opponent = of_trial(trial);
        return opponent ? opponent->hue : 0.0;
    }

    friend bool operator==(const Opponents& a, const Opponents& b) {
        return std::equal(
            a.genomes.begin(), a.genomes.end(), b.genomes.begin(), b.genomes.end(),
            [](const GenomePtr& one, const GenomePtr& other) { return *one == *other; });
    }
};

}  // namespace cambrian
