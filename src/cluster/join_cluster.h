#pragma once

// Makes a back-end from an address. Programs that evolve use this layer through it.

#include "cluster/connection/cluster_address.h"
#include "core/result.h"
#include "core/threads/thread_share.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/kinds/evolution_kinds.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

struct ClusterUse {
    // Own cores that evaluate, at least 1.
    ThreadShare threads = {.workers = 1, .priority = ThreadPriority::kNormal};
    std::filesystem::path experiment;  // file of the run; empty if it is not saved
};

// Fails for permanent errors (cluster_connection.h). An unreachable server is not one of these: the
// run works alone until it can connect.
Result<std::unique_ptr<EvaluationBackend>> join_cluster(const EvolutionKinds& kinds,
                                                        const ClusterAddress& address,
                                                        const ClusterUse& use);

// Checks whether join_cluster() would fail now.
Status check_cluster(const ClusterAddress& address);

// Returns what is open to others: messages and a password on a connection that is neither encrypted
// nor stays on this machine, and a file of credentials that other users can read.
std::vector<std::string> openness_warnings(const ClusterAddress& address);

// Returns the displayed name of this machine.
std::string machine_name();

}  // namespace cambrian
