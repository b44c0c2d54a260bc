#pragma once

// Which kinds of the catalog and which kinds of references the user lets random genomes and
// mutation use.

#include "genome/founder_settings.h"
#include "genome/kind_catalog.h"
#include "genome/source_rules.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// Catalog indices in catalog order. Functions and joints are never none: settings that leave
// nothing count as saying nothing (all joints, if the catalog has none of the usual).
std::vector<std::uint8_t> enabled_functions(const FounderSettings& settings,
                                            const KindCatalog& catalog);
std::vector<std::uint8_t> enabled_joints(const FounderSettings& settings,
                                         const KindCatalog& catalog);
// Absolute channel numbers; may be none.
std::vector<std::uint8_t> enabled_channels(const FounderSettings& settings,
                                           const KindCatalog& catalog);

// Kinds new references within the scope may be of; may be none. Those to sensors need a channel.
std::vector<SourceKind> enabled_references(SourceScope scope, const FounderSettings& settings,
                                           const KindCatalog& catalog);
bool is_enabled(SourceKind kind, SourceScope scope, const FounderSettings& settings,
                const KindCatalog& catalog);

}  // namespace cambrian
