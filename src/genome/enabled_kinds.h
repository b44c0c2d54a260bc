#pragma once

// Which kinds of the catalog the user lets random genomes and mutation use.

#include "genome/founder_settings.h"
#include "genome/kind_catalog.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// Catalog indices in catalog order, never empty: ids the catalog lacks are ignored, and a list
// that leaves nothing counts as empty. An empty list of functions enables all of them; an empty
// list of joints enables "rigid" and "rotary" (all joints, if the catalog has neither).
std::vector<std::uint8_t> enabled_functions(const FounderSettings& settings,
                                            const KindCatalog& catalog);
std::vector<std::uint8_t> enabled_joints(const FounderSettings& settings,
                                         const KindCatalog& catalog);

}  // namespace cambrian
