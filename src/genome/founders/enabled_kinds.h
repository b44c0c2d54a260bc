#pragma once

// The catalog's kinds and the kinds of references that settings allow in random genomes and
// mutation.

#include "genome/founder_settings.h"
#include "genome/kind_catalog.h"
#include "genome/source_rules.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// Returns whether an entry of the catalog, or a kind of reference, is enabled by default.
template <class Entry>
bool is_usual(const Entry& entry) {
    if constexpr (requires { entry.usual; })
        return entry.usual;
    else
        return true;
}

// Return catalog indices in catalog order. Functions and joints are never empty: settings that
// exclude all of them are ignored (if the catalog has no usual joint, all are allowed).
std::vector<std::uint8_t> enabled_functions(const FounderSettings& settings,
                                            const KindCatalog& catalog);
std::vector<std::uint8_t> enabled_joints(const FounderSettings& settings,
                                         const KindCatalog& catalog);
// Returns channel numbers in the catalog's list of all channels; may be empty.
std::vector<std::uint8_t> enabled_channels(const FounderSettings& settings,
                                           const KindCatalog& catalog);

// Returns the kinds of organs that new genes may have; none by default.
std::vector<std::uint8_t> enabled_organs(const FounderSettings& settings,
                                         const KindCatalog& catalog);

// Returns the kinds of new references that are allowed in the scope; may be empty. References to
// sensors need an enabled channel.
std::vector<SourceKind> enabled_references(SourceScope scope, const FounderSettings& settings,
                                           const KindCatalog& catalog);
bool is_enabled(SourceKind kind, SourceScope scope, const FounderSettings& settings,
                const KindCatalog& catalog);

}  // namespace cambrian
