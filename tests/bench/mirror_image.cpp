#include "bench/mirror_image.h"

namespace cambrian::bench {

BenchCreature mirror_image(const BenchCreature& creature, Flip flip) {
    BenchCreature image = creature;
    image.plan = cambrian::mirror_image(creature.plan, flip);
    for (double& target : image.targets)
        target = -target;
    return image;
}

}  // namespace cambrian::bench
