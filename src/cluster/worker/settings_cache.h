#pragma once

// The settings that a worker used recently, by key. May be used on any thread.

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

    SettingsPtr find(std::uint64_t key);  // null if unknown
    // Fails if the text does not match the key or is not a settings file.
    Result<SettingsPtr> add(std::uint64_t key, std::string_view text, const EvolutionKinds& kinds);

private:
    std::mutex mutex_;
    std::list<std::pair<std::uint64_t, SettingsPtr>> entries_;  // most recently used first
};

}  // namespace cambrian
