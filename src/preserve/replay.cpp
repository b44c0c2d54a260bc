#include "preserve/replay.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

// Returns how many interventions are in the snapshot of a tick.
std::size_t count_in_snapshot(std::span<const Intervention> all, std::uint64_t tick) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < all.size() && all[i].tick <= tick; ++i) {
        if (all[i].tick < tick || all[i].what == intervention::kRest) count = i + 1;
    }
    return count;
}

}  // namespace

std::span<const Intervention> interventions_up_to(std::span<const Intervention> all,
                                                  std::uint64_t tick) {
    return all.first(count_in_snapshot(all, tick));
}

std::vector<Intervention> interventions_in(std::span<const Intervention> all,
                                           const ReplaySpan& span) {
    const std::size_t first = count_in_snapshot(all, span.from);
    const std::size_t end = std::max(first, count_in_snapshot(all, span.to));
    std::vector<Intervention> found;
    for (const Intervention& each : all.subspan(first, end - first)) {
        if (each.what != intervention::kRestock) found.push_back(each);
    }
    return found;
}

Status repeat(Preserve& preserve, std::span<const Intervention>& left) {
    while (!left.empty() && left.front().tick == preserve.ticks()) {
        const Intervention& next = left.front();
        const Result<std::uint64_t> number = preserve.intervene(next);
        if (!number) return number.error();
        if (*number != next.number) {
            return Error{fmt::format("the replay of \"{}\" at tick {} is about {}, not {}",
                                     next.what, next.tick, *number, next.number)};
        }
        left = left.subspan(1);
    }
    return {};
}

}  // namespace cambrian
