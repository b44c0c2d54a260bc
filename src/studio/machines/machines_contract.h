#pragma once

// The data of the evaluating machines that panels see, and the requests they may make of them.

#include "cluster/connection/cluster_address.h"
#include "evolution/evaluation/backend_status.h"

#include <string>
#include <variant>

namespace cambrian {

// Opens or closes the card of machines.
struct ToggleMachines {};
// Evaluates on this cluster from now on, besides this machine's cores.
struct JoinCluster {
    ClusterLogin login;
};
// Evaluates on this machine's cores alone from now on.
struct LeaveCluster {};

using MachinesRequest = std::variant<ToggleMachines, JoinCluster, LeaveCluster>;

struct MachinesView {
    ClusterLogin login;    // the present or last one
    BackendStatus status;  // status of the back-end in use
    bool card_open = false;
    bool joining = false;  // an attempt to join is under way
    bool joined = false;   // the cluster evaluates whenever it can be reached
    std::string problem;   // why the last attempt to join failed; empty if it succeeded
};

// Returns whether the user asked for a cluster, so that its state must be displayed.
inline bool cluster_wanted(const MachinesView& machines) {
    return machines.joining || machines.joined || !machines.problem.empty();
}

}  // namespace cambrian
