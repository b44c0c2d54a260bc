#pragma once

// A bench creature seen in a mirror, its targets too.

#include "bench/bench_creature.h"
#include "support/mirror_image.h"

namespace cambrian::bench {

BenchCreature mirror_image(const BenchCreature& creature, Flip flip);

}  // namespace cambrian::bench
