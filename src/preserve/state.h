#pragma once

// The complete state of a preserve between two ticks, but for contacts and sounds, which begin
// again when a preserve goes on from it (preserve/README.md 7).

#include "core/result.h"
#include "evolution/settings/wall_lines.h"
#include "preserve/life/resident.h"
#include "preserve/world/common_senses.h"
#include "preserve/world/food.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace cambrian {

struct Lineage {
    std::uint64_t number = 0;  // of its founder
    GenomePtr genome;          // the founder's
};

struct PreserveState {
    std::uint64_t tick = 0;
    std::uint64_t next_number = 1;  // of the next creature
    std::uint64_t attempts = 0;     // at a birth so far
    std::uint64_t restocked = 0;    // newcomers so far
    Energy ambient = 0;
    std::vector<Pellet> plants, flesh;
    std::vector<Lineage> lineages;         // of the living, in ascending order
    std::vector<ResidentState> residents;  // in ascending order of numbers
    CommonSenses::Moment scents;
    std::vector<WallLine> walls;
};

// Returns the numbers of a state, without genomes and methods of breeding. They decide its digest.
std::vector<std::uint64_t> words_of(const PreserveState& state);
std::uint64_t digest_of(std::span<const std::uint64_t> words);

// The part of a life that words leave out.
struct Origin {
    GenomePtr genome;
    std::string method;
};
using FindOrigin = std::function<Result<Origin>(std::uint64_t number)>;

// Returns the state of these words; `find` returns the origins of creatures and founders. Fails if
// they are not those of a state.
Result<PreserveState> state_of(std::span<const std::uint64_t> words, const FindOrigin& find);

}  // namespace cambrian
