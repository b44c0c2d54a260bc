#pragma once

// Words of panels about a preserve.

#include "preserve/engine/preserve_picture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

// Returns "137 creatures · 4 lineages · 12.4 × real time · energy: light 41 % ...".
std::string world_words(const PreservePicture& picture);
// Returns "alive", or how it died: "died of hunger at 2:05".
std::string fate_words(const Life& life);

// Returns why a creature is in the museum: "founded a lineage of 20".
std::string reason_words(const MuseumPiece& piece);

// Returns "Tavinor 12", or "creature 12" if neither the living nor the dead in sight have its
// genes.
std::string called(const PreservePicture& picture, std::uint64_t number);

// A lineage and its living members.
struct LineageCount {
    std::uint64_t number = 0;
    std::size_t members = 0;
    std::uint64_t eldest = 0;                    // number of its first member
    std::shared_ptr<const Phenotype> phenotype;  // of its first member
};
// Returns the largest lineage first.
std::vector<LineageCount> lineages_in(const PreservePicture& picture);

}  // namespace cambrian
