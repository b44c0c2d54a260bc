#pragma once

// The mirror image of a bench creature, with its targets.

#include "bench/bench_creature.h"
#include "support/mirror_image.h"

namespace cambrian::bench {

BenchCreature mirror_image(const BenchCreature& creature, Flip flip);

}  // namespace cambrian::bench
