#include "app/preserve/preserve_replay.h"

#include "app/preserve/past_world.h"
#include "app/process/messages.h"
#include "core/text/number_text.h"
#include "persist/preserve/preserve_file.h"
#include "simulator/simulator_version.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

// Returns the digest at the tick of the next snapshot; nothing if a stop was requested.
Result<std::optional<std::uint64_t>> digest_after(const std::string& file,
                                                  const SavedPreserve& saved,
                                                  const SnapshotEntry& from,
                                                  std::uint64_t last_tick,
                                                  const EvolutionKinds& kinds, ThreadPool& pool,
                                                  const TrialWatch& watch) {
    Result<PastWorld> world = PastWorld::at(file, saved, from, last_tick, kinds);
    if (!world) return world.error();
    const Result<bool> reached = world->go_to(last_tick, pool, [&](std::uint64_t tick) {
        watch.note(static_cast<double>(tick) * kBrainTick);
        return !watch.stop.stop_requested();
    });
    if (!reached) return reached.error();
    if (!*reached) return std::optional<std::uint64_t>();
    return std::optional(digest_of(words_of(world->preserve().save())));
}

std::string seconds_text(std::uint64_t tick) {
    return short_text(static_cast<double>(tick) / 60.0);
}

}  // namespace

ExitStatus verify_preserve(const std::string& file, const EvolutionKinds& kinds, LongWork& work) {
    const Result<SavedPreserve> saved = load_preserve(file, kinds);
    if (!saved) return fail(saved.error());
    const auto& snapshots = saved->snapshots;
    ThreadPool pool(ThreadPool::default_workers());
    work.begin("replaying", static_cast<double>(snapshots.back().tick) / 60.0);
    for (std::size_t i = 0; i + 1 < snapshots.size(); ++i) {
        const std::string until = seconds_text(snapshots[i + 1].tick);
        const auto digest = digest_after(file, *saved, snapshots[i], snapshots[i + 1].tick, kinds,
                                         pool, work.watch());
        if (!digest) {
            return fail({fmt::format("{}: snapshot of {} s: {}", file,
                                     seconds_text(snapshots[i].tick), digest.error().message)},
                        ExitStatus::kFailed);
        }
        if (!*digest)
            return fail({fmt::format("{}: stopped before {} s", file, until)}, ExitStatus::kFailed);
        if (**digest == snapshots[i + 1].digest) continue;
        std::string message = fmt::format("{}: the replay differs at {} s", file, until);
        if (saved->origin.simulator != kSimulatorVersion)
            message += fmt::format("; it was begun by simulator {}, this is {}",
                                   saved->origin.simulator, kSimulatorVersion);
        return fail({message}, ExitStatus::kFailed);
    }
    return print_result_line(fmt::format("{}: replay verified, {} snapshots up to {} s", file,
                                         snapshots.size(), seconds_text(snapshots.back().tick)));
}

}  // namespace cambrian
