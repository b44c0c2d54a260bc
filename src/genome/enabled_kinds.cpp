#include "genome/enabled_kinds.h"

#include <algorithm>
#include <string>

namespace cambrian {
namespace {

template <class Entry>
std::vector<std::uint8_t> named(const std::vector<Entry>& entries,
                                const std::vector<std::string>& ids) {
    std::vector<std::uint8_t> indices;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (std::find(ids.begin(), ids.end(), entries[i].id) != ids.end()) {
            indices.push_back(static_cast<std::uint8_t>(i));
        }
    }
    return indices;
}

template <class Entry>
std::vector<std::uint8_t> all(const std::vector<Entry>& entries) {
    std::vector<std::uint8_t> indices;
    for (std::size_t i = 0; i < entries.size(); ++i)
        indices.push_back(static_cast<std::uint8_t>(i));
    return indices;
}

}  // namespace

std::vector<std::uint8_t> enabled_functions(const FounderSettings& settings,
                                            const KindCatalog& catalog) {
    std::vector<std::uint8_t> chosen = named(catalog.functions, settings.functions);
    return chosen.empty() ? all(catalog.functions) : chosen;
}

std::vector<std::uint8_t> enabled_joints(const FounderSettings& settings,
                                         const KindCatalog& catalog) {
    std::vector<std::uint8_t> chosen = named(catalog.joints, settings.joints);
    if (chosen.empty()) chosen = named(catalog.joints, {"rigid", "rotary"});
    return chosen.empty() ? all(catalog.joints) : chosen;
}

}  // namespace cambrian
