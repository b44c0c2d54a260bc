#pragma once

#include "cluster/connection/cluster_address.h"
#include "core/result.h"
#include "core/threads/thread_share.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <functional>
#include <memory>
#include <optional>

namespace cambrian {

// Makes a back-end that evaluates on the cluster and on these threads of this machine. It may
// run on any thread and take seconds. The error says why the address cannot be used.
using ClusterJoining = std::function<Result<std::shared_ptr<EvaluationBackend>>(
    const ClusterAddress& address, const ThreadShare& threads)>;

// The means by which the studio may evaluate creatures.
struct MachineOptions {
    // Evaluating threads of this machine; 0 workers mean one per core.
    ThreadShare threads = {.workers = 0};
    // Cluster to join at the start, instead of the stored one.
    std::optional<ClusterLogin> cluster = std::nullopt;
    ClusterJoining join = nullptr;  // null if no cluster can be joined
};

}  // namespace cambrian
