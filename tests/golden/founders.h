#pragma once

#include "genome/founders/random_genome.h"

namespace cambrian::golden {

// Settings and founders with joints of every kind.
FounderSettings all_joints();
Genome founder(int number);

}  // namespace cambrian::golden
