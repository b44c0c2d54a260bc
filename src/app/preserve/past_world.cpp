#include "app/preserve/past_world.h"

#include "preserve/laws.h"
#include "preserve/replay.h"

#include <utility>

namespace cambrian {

Result<PastWorld> PastWorld::at(const std::string& file, const SavedPreserve& saved,
                                const SnapshotEntry& from, std::uint64_t last,
                                const EvolutionKinds& kinds) {
    const Result<PreserveState> state = load_snapshot(file, from, kinds);
    if (!state) return state.error();
    const Result<SettingsPtr> laws =
        laws_at(saved.origin.settings, saved.interventions, from.tick, kinds);
    if (!laws) return laws.error();
    auto preserve =
        Preserve::resume(saved.origin.settings, kinds, saved.origin.founders, *state, *laws);
    if (!preserve) return preserve.error();
    return PastWorld(std::move(*preserve),
                     interventions_in(saved.interventions, {from.tick, last}));
}

Result<bool> PastWorld::go_to(std::uint64_t tick, ThreadPool& pool,
                              const std::function<bool(std::uint64_t)>& goes_on) {
    while (true) {
        if (Status repeated = repeat(*preserve_, left_); !repeated) return repeated.error();
        if (preserve_->ticks() >= tick) return true;
        if (!goes_on(preserve_->ticks())) return false;
        preserve_->tick(pool);
        const Chronicle happened = preserve_->take_chronicle();
        died_.insert(died_.end(), happened.died.begin(), happened.died.end());
    }
}

}  // namespace cambrian
