#pragma once

#include "core/random.h"
#include "genome/founder_settings.h"
#include "genome/genome.h"

namespace cambrian {

// Returns a valid founder within the settings' limits. It has a movable joint if 20 attempts give
// one (genome/README.md 4).
Genome random_genome(const FounderSettings& settings, const KindCatalog& catalog,
                     RandomStream& stream);

}  // namespace cambrian
