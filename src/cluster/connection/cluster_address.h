#pragma once

// The address of a cluster and the credentials for it, as typed and as parsed.

#include "core/result.h"

#include <string>
#include <vector>

namespace cambrian {

inline constexpr const char* kStandardClusterName = "cambrian";

// As typed on the command line or in a dialog; a field without input is empty.
struct ClusterLogin {
    // "nats://host[:4222]" or "tls://host"; several are separated by commas.
    std::string servers = {};
    std::string name = {};         // name of the cluster; several clusters may share a server
    std::string credentials = {};  // file that authenticates the user
    std::string authority = {};    // file of the certificate authority, PEM; empty for the system's

    friend bool operator==(const ClusterLogin&, const ClusterLogin&) = default;
};

struct ClusterAddress {
    std::vector<std::string> servers;  // "nats://host:port" each; together one server cluster
    std::string name;
    std::string credentials;
    std::string authority;
    bool encrypted = false;
    bool on_this_machine = false;  // every server's host is the loopback interface
};

// Fails, in one sentence, for anything that cannot be an address: another scheme, a password (which
// would stay in the shell's history and in the list of processes), a mix of encrypted and plain
// servers, an invalid name, or two names. A server may have the cluster's name as its path
// ("nats://host/lab").
Result<ClusterAddress> cluster_address(const ClusterLogin& login);

}  // namespace cambrian
