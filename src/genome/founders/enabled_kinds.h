#pragma once

// Kinds of the catalog and kinds of references that the settings allow in random genomes and
// mutation.

#include "genome/founder_settings.h"
#include "genome/kind_catalog.h"
#include "genome/source_rules.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// Whether an entry of the catalog, or a kind of reference, is used where settings say nothing.
template <class Entry>
bool is_usual(const Entry& entry) {
    if constexpr (requires { entry.usual; })
        return entry.usual;
    else
        return true;
}

// Catalog indices in catalog order. Functions and joints are never empty: settings that exclude all
// of them are ignored (all joints are allowed if the catalog has none of the usual ones).
std::vector<std::uint8_t> enabled_functions(const FounderSettings& settings,
                                            const KindCatalog& catalog);
std::vector<std::uint8_t> enabled_joints(const FounderSettings& settings,
                                         const KindCatalog& catalog);
// Absolute channel numbers; may be empty.
std::vector<std::uint8_t> enabled_channels(const FounderSettings& settings,
                                           const KindCatalog& catalog);

// Allowed kinds of new references within the scope; may be empty. References to sensors need a
// channel.
std::vector<SourceKind> enabled_references(SourceScope scope, const FounderSettings& settings,
                                           const KindCatalog& catalog);
bool is_enabled(SourceKind kind, SourceScope scope, const FounderSettings& settings,
                const KindCatalog& catalog);

}  // namespace cambrian
