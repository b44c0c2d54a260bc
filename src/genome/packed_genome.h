#pragma once

// A genotype that is kept in little memory, for worlds that keep many of them and read each seldom.

#include "genome/genome.h"

#include <cstddef>
#include <memory>
#include <string>

namespace cambrian {

// Immutable; copies share the bytes. A genotype of 16 part genes takes about 1 kB, instead of 6.
class PackedGenome {
public:
    PackedGenome() = default;  // of no genotype
    // The genome must be valid (validate()).
    explicit PackedGenome(const Genome& genome);

    bool empty() const { return packed_ == nullptr; }
    // Returns the genotype with all its fields; null if there is none.
    GenomePtr unpack() const;

private:
    struct Packed {
        std::string bytes;     // deflated
        std::size_t size = 0;  // bytes when inflated
    };
    std::shared_ptr<const Packed> packed_;
};

}  // namespace cambrian
