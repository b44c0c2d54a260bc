#include "cluster/worker/settings_cache.h"

#include "cluster/messages/judging_settings.h"

#include <algorithm>
#include <memory>
#include <string>

namespace cambrian {

SettingsPtr SettingsCache::find(std::uint64_t key) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const auto& entry) { return entry.first == key; });
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front().second;
}

Result<SettingsPtr> SettingsCache::add(std::uint64_t key, std::string_view text,
                                       const EvolutionKinds& kinds) {
    if (settings_key(text) != key)
        return Error{"settings of a run: they are not those the run asks for"};
    Result<ExperimentSettings> read = read_judging_settings(text, "settings of a run", kinds);
    if (!read) return read.error();
    SettingsPtr settings = std::make_shared<const ExperimentSettings>(*std::move(read));
    const std::lock_guard lock(mutex_);
    entries_.emplace_front(key, settings);
    if (entries_.size() > kMost) entries_.pop_back();
    return settings;
}

}  // namespace cambrian
