#pragma once

// What panels see of the machines that evaluate and what they may request of them.

#include "cluster/connection/cluster_address.h"
#include "evolution/evaluation/backend_status.h"

#include <string>
#include <variant>

namespace cambrian {

// Opens or closes the card of machines.
struct ToggleMachines {};
// Evaluates on this cluster from now on, besides the own cores.
struct JoinCluster {
    ClusterLogin login;
};
// Evaluates on the own cores alone from now on.
struct LeaveCluster {};

using MachinesRequest = std::variant<ToggleMachines, JoinCluster, LeaveCluster>;

struct MachinesView {
    ClusterLogin login;    // the present one, or the last
    BackendStatus status;  // of what evaluates now
    bool card_open = false;
    bool joining = false;  // an attempt is under way
    bool joined = false;   // evaluations go to the cluster whenever it is there
    std::string problem;   // why the last attempt failed; empty if it did not
};

// Whether a cluster was asked for, so that its state has to be told.
inline bool cluster_wanted(const MachinesView& machines) {
    return machines.joining || machines.joined || !machines.problem.empty();
}

}  // namespace cambrian
