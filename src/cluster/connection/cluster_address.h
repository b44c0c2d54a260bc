#pragma once

// The address of a cluster and the credentials for it, as typed and as used.

#include "core/result.h"

#include <string>
#include <vector>

namespace cambrian {

inline constexpr const char* kStandardClusterName = "cambrian";

// As typed, on the command line or in a dialog; empty where nothing is.
struct ClusterLogin {
    std::string servers = {};  // "nats://host[:4222]" or "tls://host", several with commas between
    std::string name = {};     // of the cluster; several share a server
    std::string credentials = {};  // file that proves who one is
    std::string authority = {};    // file of the certificate authority, PEM; the system's if empty

    friend bool operator==(const ClusterLogin&, const ClusterLogin&) = default;
};

struct ClusterAddress {
    std::vector<std::string> servers;  // "nats://host:port" each; one server cluster
    std::string name;
    std::string credentials;
    std::string authority;
    bool encrypted = false;
    bool on_this_machine = false;  // every server's host is the loopback interface
};

// Fails, in one sentence, on what cannot be an address: another scheme, a password (it would stay
// in the shell's history and in the list of processes), encrypted and plain servers together, a
// name that is none, two names. A server may carry the cluster's name as its path
// ("nats://host/lab").
Result<ClusterAddress> cluster_address(const ClusterLogin& login);

}  // namespace cambrian
