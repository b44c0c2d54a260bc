#include "genome/founders/enabled_kinds.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

namespace cambrian {
namespace {

// Returns the indices of enabled entries. Entries without a flag are enabled if they are usual.
template <class Entries>
std::vector<std::uint8_t> enabled(const Entries& entries,
                                  const std::map<std::string, bool>& flags) {
    std::vector<std::uint8_t> indices;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto flag = flags.find(std::string(entries[i].id));
        if (flag == flags.end() ? is_usual(entries[i]) : flag->second)
            indices.push_back(static_cast<std::uint8_t>(i));
    }
    return indices;
}

}  // namespace

std::vector<std::uint8_t> enabled_functions(const FounderSettings& settings,
                                            const KindCatalog& catalog) {
    auto chosen = enabled(catalog.functions, settings.functions);
    return chosen.empty() ? enabled(catalog.functions, {}) : chosen;
}

std::vector<std::uint8_t> enabled_joints(const FounderSettings& settings,
                                         const KindCatalog& catalog) {
    auto chosen = enabled(catalog.joints, settings.joints);
    if (chosen.empty()) chosen = enabled(catalog.joints, {});
    if (chosen.empty()) {
        chosen.resize(catalog.joints.size());
        std::iota(chosen.begin(), chosen.end(), std::uint8_t{0});
    }
    return chosen;
}

std::vector<std::uint8_t> enabled_channels(const FounderSettings& settings,
                                           const KindCatalog& catalog) {
    return enabled(catalog.channels, settings.channels);
}

std::vector<std::uint8_t> enabled_organs(const FounderSettings& settings,
                                         const KindCatalog& catalog) {
    return enabled(catalog.organs, settings.organs);
}

std::vector<SourceKind> enabled_references(SourceScope scope, const FounderSettings& settings,
                                           const KindCatalog& catalog) {
    const bool has_sensors = !enabled_channels(settings, catalog).empty();
    std::vector<SourceKind> kinds;
    for (const std::uint8_t index : enabled(source_rules(), settings.references)) {
        const auto kind = SourceKind(index);
        const bool readable = has_sensors || source_rule(kind).reads != SourceReads::kSensor;
        if (readable && is_allowed(kind, scope)) kinds.push_back(kind);
    }
    return kinds;
}

bool is_enabled(SourceKind kind, SourceScope scope, const FounderSettings& settings,
                const KindCatalog& catalog) {
    const auto kinds = enabled_references(scope, settings, catalog);
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace cambrian
