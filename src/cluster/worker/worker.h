#pragma once

// A worker, which computes units of any coordinator until it is stopped.

#include "cluster/messages/work_queue.h"
#include "core/threads/thread_share.h"
#include "evolution/kinds/evolution_kinds.h"

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace cambrian {

struct WorkerOptions {
    std::uint64_t id = 0;  // different from that of any other worker
    ThreadShare threads;   // at least 1
    std::string name;      // displayed name
    // Prints a line for users: connected, connection lost, which run is refused and why. May be
    // called on any thread.
    std::function<void(std::string_view)> say;
};

// Returns after a stop request, once unfinished units are given back. Units of a run that refuses
// this worker are given back as long as the run says so.
void work_for_cluster(const EvolutionKinds& kinds, WorkerQueue& queue, const WorkerOptions& options,
                      const std::stop_token& stop);

}  // namespace cambrian
