#pragma once

// How a command says which cluster it means.

#include "cluster/connection/cluster_address.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// The cluster's address as what the command is about.
void add_cluster_address(CLI::App& app, ClusterLogin& login);
// As an option of a command that can do without: --cluster.
void add_cluster_choice(CLI::App& app, ClusterLogin& login);

}  // namespace cambrian
