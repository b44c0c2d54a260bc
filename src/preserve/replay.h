#pragma once

// Repeats what people did to a preserve, so that a replay has the same bits.

#include "preserve/preserve.h"

#include <span>
#include <vector>

namespace cambrian {

// A moment between two ticks at which a snapshot was taken. Several interventions may have the same
// tick; those up to its last rest are in its snapshot.
struct ReplaySpan {
    std::uint64_t from = 0;  // ticks of two snapshots
    std::uint64_t to = 0;
};

// Returns, in their order, the interventions of people after one snapshot that are in the other.
std::vector<Intervention> interventions_in(std::span<const Intervention> all,
                                           const ReplaySpan& span);

// Returns those that are in the snapshot of a tick.
std::span<const Intervention> interventions_up_to(std::span<const Intervention> all,
                                                  std::uint64_t tick);

// Carries out those of the present tick and removes them from `left`. Fails if one of them cannot
// be carried out, or has another result.
Status repeat(Preserve& preserve, std::span<const Intervention>& left);

}  // namespace cambrian
