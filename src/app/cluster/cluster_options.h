#pragma once

// Command-line options that name a cluster.

#include "app/command_line/command_files.h"
#include "cluster/connection/cluster_address.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace cambrian {

// Adds the cluster's address as a positional argument of a command that needs one.
void add_cluster_address(CLI::App& app, ClusterLogin& login);
// Adds the cluster's address as the option --cluster.
void add_cluster_choice(CLI::App& app, ClusterLogin& login);

// Adds the login's files to the files that the command reads.
void add_login_files(CommandFiles& files, const ClusterLogin& login);

// Prints what of the connection and its credentials is open to others.
void say_of_openness(const ClusterAddress& address);

// Returns the address if this build can use it. Says what is open to others.
Result<ClusterAddress> usable_cluster(const ClusterLogin& login);

}  // namespace cambrian
