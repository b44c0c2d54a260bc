#pragma once

#include "genome/founders/random_genome.h"

namespace cambrian::golden {

// Settings and founders with joints of every kind.
FounderSettings all_joints();
Genome founder(int number);

// The same with organs and senses of every kind.
FounderSettings all_organs();
Genome founder_with_organs(int number);

}  // namespace cambrian::golden
