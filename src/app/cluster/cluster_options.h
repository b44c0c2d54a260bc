#pragma once

// How a command says which cluster it means.

#include "app/command_line/command_files.h"
#include "cluster/connection/cluster_address.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// The cluster's address as what the command is about.
void add_cluster_address(CLI::App& app, ClusterLogin& login);
// As an option of a command that can do without: --cluster.
void add_cluster_choice(CLI::App& app, ClusterLogin& login);

// The files that the login names are among those the command reads.
void add_login_files(CommandFiles& files, const ClusterLogin& login);

// The address of a cluster that this build can use. Says so where what travels can be read.
Result<ClusterAddress> usable_cluster(const ClusterLogin& login);

}  // namespace cambrian
