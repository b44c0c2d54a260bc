#pragma once

// A preserve file computed again from one of its snapshots, with what people did.

#include "core/threads/thread_pool.h"
#include "persist/preserve/preserve_file.h"
#include "preserve/preserve.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

class PastWorld {
public:
    // Begins at a snapshot. What people did up to the snapshot of tick `last` is repeated.
    static Result<PastWorld> at(const std::string& file, const SavedPreserve& saved,
                                const SnapshotEntry& from, std::uint64_t last,
                                const EvolutionKinds& kinds);

    // Goes on to a tick and does what people did until then. `goes_on` is asked before each tick,
    // with the tick; if it returns false, so does this.
    Result<bool> go_to(std::uint64_t tick, ThreadPool& pool,
                       const std::function<bool(std::uint64_t)>& goes_on);
    const Preserve& preserve() const { return *preserve_; }
    const std::vector<Life>& died() const { return died_; }  // since it began

private:
    PastWorld(std::unique_ptr<Preserve> preserve, std::vector<Intervention> interventions)
        : preserve_(std::move(preserve)),
          interventions_(std::move(interventions)),
          left_(interventions_) {}

    std::unique_ptr<Preserve> preserve_;
    std::vector<Intervention> interventions_;
    std::span<const Intervention> left_;
    std::vector<Life> died_;
};

}  // namespace cambrian
