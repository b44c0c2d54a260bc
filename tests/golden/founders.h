#pragma once

#include "genome/founders/random_genome.h"
#include "support/kinds.h"

namespace cambrian::golden {

// Settings and founders with joints of every kind.
FounderSettings all_joints(const KindCatalog& catalog = test::kind_catalog());
Genome founder(int number, const KindCatalog& catalog = test::kind_catalog());

// The same with organs that give off sound and scent, and all senses but those of stretching.
FounderSettings with_emitters();
Genome founder_with_organs(int number);

// The same as the first with deformers and their senses.
FounderSettings with_deformers();
Genome founder_with_deformers(int number);

}  // namespace cambrian::golden
