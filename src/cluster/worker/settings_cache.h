#pragma once

// The settings a worker has read lately, by their keys. Any thread.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <mutex>
#include <string_view>
#include <utility>

namespace cambrian {

class SettingsCache {
public:
    static constexpr std::size_t kMost = 16;

    SettingsPtr find(std::uint64_t key);  // null if not there
    // Fails if the text is not that of the key or no settings.
    Result<SettingsPtr> add(std::uint64_t key, std::string_view text, const EvolutionKinds& kinds);

private:
    std::mutex mutex_;
    std::list<std::pair<std::uint64_t, SettingsPtr>> entries_;  // the last one used first
};

}  // namespace cambrian
