#pragma once

// The museum of a preserve: creatures that are kept in sight after their death (preserve/README.md
// 11).

#include "genome/genome.h"
#include "preserve/life/offspring.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

inline constexpr std::uint64_t kMembersForMuseum = 20;        // living, of a lineage
inline constexpr std::uint64_t kTicksPerMuseumVisit = 36000;  // 10 min

namespace museum_reason {
inline constexpr const char* kLineage = "lineage";    // founder of a lineage that became so large
inline constexpr const char* kChildren = "children";  // had the most children of the living
}  // namespace museum_reason

struct MuseumPiece {
    std::uint64_t number = 0;  // of the creature
    std::uint64_t tick = 0;    // at which it came into the museum
    std::string reason = {};   // one of the names above
    std::uint64_t count = 0;   // of living members, or of children, at that tick
    GenomePtr genome = {};
};

// Returns how many of the living belong to a lineage.
std::uint64_t living_members(const Residents& residents, std::uint64_t lineage);
// Returns the living creature with the most children, of several the eldest; null if none has any.
const Resident* most_fertile(const Residents& residents);

// Adds pieces, but none for whose creature and reason there is one already.
void add_pieces(std::vector<MuseumPiece>& museum, std::span<const MuseumPiece> later);

}  // namespace cambrian
