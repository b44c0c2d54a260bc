#pragma once

// The back-end of a coordinator. The cores of its own machine always evaluate. Units go to workers
// as long as the queue is connected and workers answer.

#include "cluster/messages/work_queue.h"
#include "cluster/units/unit_child.h"
#include "core/threads/thread_share.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/kinds/evolution_kinds.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace cambrian {

struct ClusterOptions {
    // Own cores that evaluate, at least 1.
    ThreadShare threads = {.workers = 1, .priority = ThreadPriority::kNormal};
    std::string name;          // displayed name of this machine
    std::string server;        // for BackendStatus
    std::string cluster;       // likewise
    std::uint64_t run = 0;     // different from that of any other run; has no influence on results
    std::uint64_t secret = 0;  // selects the results that are computed again as a check
    // Runs a unit in a separate process; see unit_child.h. Without it a unit that seems to crash
    // its workers is computed in this process.
    ChildProcess child;
    // Folder for the genome that crashes a process; empty for the working folder.
    std::filesystem::path crash_folder;
};

// Computes the proof set first, which takes 0.2 s. The queue need not be connected. evaluate()
// returns false without a stop request only if the run cannot continue (two workers with different
// bits, a genome that crashes the process); status().failure has the reason.
std::unique_ptr<EvaluationBackend> make_cluster_backend(const EvolutionKinds& kinds,
                                                        std::unique_ptr<CoordinatorQueue> queue,
                                                        ClusterOptions options);

}  // namespace cambrian
