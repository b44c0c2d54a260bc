#pragma once

// Makes a back-end from an address: the interface of this layer for programs that evolve.

#include "cluster/connection/cluster_address.h"
#include "core/result.h"
#include "core/threads/thread_priority.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/kinds/evolution_kinds.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace cambrian {

struct ClusterUse {
    std::size_t threads = 1;  // own cores that evaluate, at least 1
    ThreadPriority priority = ThreadPriority::kNormal;
    std::filesystem::path experiment;  // where the run is kept; empty if it is not
};

// Fails for errors that waiting does not cure (cluster_connection.h). An unreachable server is no
// such error: the run works alone until it can connect.
Result<std::unique_ptr<EvaluationBackend>> join_cluster(const EvolutionKinds& kinds,
                                                        const ClusterAddress& address,
                                                        const ClusterUse& use);

// Whether join_cluster() would fail now.
Status check_cluster(const ClusterAddress& address);

// That others can read along, in one sentence; empty for a connection that is encrypted or does not
// leave this machine.
std::string plain_text_warning(const ClusterAddress& address);

// As workers and coordinators show this machine to people.
std::string machine_name();

// Unlike that of any other process.
std::uint64_t random_id();

}  // namespace cambrian
