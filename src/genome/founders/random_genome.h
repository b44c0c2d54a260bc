#pragma once

#include "core/random.h"
#include "genome/founder_settings.h"
#include "genome/genome.h"

namespace cambrian {

// A founder within the user's limits, valid, with a movable joint if 20 draws give one
// (genome/README.md 4).
Genome random_genome(const FounderSettings& settings, const KindCatalog& catalog,
                     RandomStream& stream);

}  // namespace cambrian
