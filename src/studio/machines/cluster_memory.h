#pragma once

#include "cluster/connection/cluster_address.h"

namespace cambrian {

// The data of a cluster that the studio stores between runs of the program.
struct ClusterMemory {
    ClusterLogin login;  // the last one entered, joined or not
    bool joined = false;

    friend bool operator==(const ClusterMemory&, const ClusterMemory&) = default;
};

}  // namespace cambrian
