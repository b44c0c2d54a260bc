#pragma once

#include "cluster/connection/cluster_address.h"
#include "core/result.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace cambrian {

// A back-end that evaluates on the cluster and on so many threads of this machine; runs on any
// thread and may take seconds. An Error says why the address cannot be used.
using ClusterJoining = std::function<Result<std::shared_ptr<EvaluationBackend>>(
    const ClusterAddress& address, std::size_t threads)>;

// What the studio may evaluate with.
struct MachineOptions {
    std::size_t workers = 0;  // own threads that evaluate; 0 is one a core
    // Joined at once instead of the one remembered.
    std::optional<ClusterLogin> cluster = std::nullopt;
    ClusterJoining join = nullptr;  // empty: no cluster can be joined
};

}  // namespace cambrian
