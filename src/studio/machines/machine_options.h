#pragma once

#include "cluster/connection/cluster_address.h"
#include "core/result.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace cambrian {

// Makes a back-end that evaluates on the cluster and on `threads` threads of this machine. It may
// run on any thread and take seconds. The error says why the address cannot be used.
using ClusterJoining = std::function<Result<std::shared_ptr<EvaluationBackend>>(
    const ClusterAddress& address, std::size_t threads)>;

// The means by which the studio may evaluate creatures.
struct MachineOptions {
    std::size_t workers = 0;  // evaluating threads of this machine; 0 means one per core
    // Cluster to join at the start, instead of the stored one.
    std::optional<ClusterLogin> cluster = std::nullopt;
    ClusterJoining join = nullptr;  // null if no cluster can be joined
};

}  // namespace cambrian
