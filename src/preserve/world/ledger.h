#pragma once

// The energy of a preserve that no creature has (preserve/README.md 3).

#include "core/assert.h"
#include "preserve/world/food.h"

namespace cambrian {

struct Ledger {
    Energy constant = 0;  // of the world, its creatures included
    Energy light = 0;     // ambient energy
    Food plants, flesh;

    // Returns the sum of light, plants and flesh.
    Energy total() const { return light + plants.energy() + flesh.energy(); }

    // Makes sure that the light can pay a price. If it has too little energy, plants become light
    // again; otherwise a world full of plants in which nobody is left would stay empty. Returns
    // false and changes nothing if all plants would not do.
    bool afford(Energy price) {
        const Energy missing = price - light;
        if (missing <= 0) return true;
        if (plants.energy() < missing) return false;
        light += plants.take_at_least(missing);
        return true;
    }

    // Turns light, which must suffice, into a plant.
    void add_plant(const Vec3& place, Energy energy) {
        CAMBRIAN_TICK_ASSERT(energy <= light, "the light pays a plant");
        plants.add(place, energy);
        light -= energy;
    }
};

}  // namespace cambrian
