#pragma once

// The same creature seen in a mirror: physics knows no left and right, so it must move as the
// mirror image of the original.

#include "bench/bench_creature.h"

namespace cambrian::bench {

// World x becomes -x. A box is its own mirror image in two ways, so there are two descriptions of
// the mirrored body: with the length of every part turned round (angle a becomes -a), or with its
// width (a becomes pi - a).
enum class Flip { kLength, kWidth };

BenchCreature mirror_image(const BenchCreature& creature, Flip flip);

}  // namespace cambrian::bench
