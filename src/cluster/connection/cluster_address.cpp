#include "cluster/connection/cluster_address.h"

#include "core/text/parsed_number.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace cambrian {
namespace {

constexpr std::string_view kPlain = "nats://";
constexpr std::string_view kEncrypted = "tls://";
constexpr int kStandardPort = 4222;
constexpr std::size_t kMostServers = 32;
constexpr std::size_t kLongestClusterName = 40;
constexpr std::size_t kLongestHost = 253;  // RFC 1035 2.3.4

struct Server {
    bool encrypted = false;
    std::string host;  // an IPv6 address in its brackets
    int port = kStandardPort;
    std::string cluster;  // empty if none is named
};

// The message does not quote anything that could be a password.
Error not_a_server(std::string_view text) {
    return Error{fmt::format(
        "'{}' is no server: expected nats://HOST, nats://HOST:PORT or tls://HOST", text)};
}

std::optional<int> port_of(std::string_view text) {
    const auto port = parsed_number<int>(text);
    return port && *port >= 1 && *port <= 65535 ? port : std::nullopt;
}

bool is_letter_or_digit(char letter) {
    return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
           (letter >= 'A' && letter <= 'Z');
}

bool is_host(std::string_view host) {
    if (host.empty() || host.size() > kLongestHost) return false;
    if (host.front() == '[') {
        return host.size() > 2 && host.back() == ']' &&
               host.substr(1, host.size() - 2).find_first_not_of("0123456789abcdefABCDEF:.%") ==
                   std::string_view::npos;
    }
    return std::all_of(host.begin(), host.end(), [](char letter) {
        return is_letter_or_digit(letter) || letter == '.' || letter == '-' || letter == '_';
    });
}

// Returns whether the host is a number of 127.0.0.0/8, not a name that begins in the same way.
bool is_loopback_number(std::string_view host) {
    return host.starts_with("127.") &&
           host.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool is_loopback(std::string_view host) {
    return host == "localhost" || host == "[::1]" || is_loopback_number(host);
}

Result<Server> server_of(std::string_view text) {
    if (text.find('@') != std::string_view::npos) {
        return Error{
            "a server's address must not hold a user or a password, which others can see "
            "in the list of processes; put them in a file and name it by --credentials"};
    }
    Server server;
    server.encrypted = text.starts_with(kEncrypted);
    if (!server.encrypted && !text.starts_with(kPlain)) return not_a_server(text);
    std::string_view rest = text.substr(server.encrypted ? kEncrypted.size() : kPlain.size());
    if (const auto slash = rest.find('/'); slash != std::string_view::npos) {
        server.cluster = rest.substr(slash + 1);
        rest = rest.substr(0, slash);
    }
    const auto colon = rest.find(':', rest.starts_with('[') ? rest.find(']') : 0);
    if (colon != std::string_view::npos) {
        const auto port = port_of(rest.substr(colon + 1));
        if (!port) return not_a_server(text);
        server.port = *port;
        rest = rest.substr(0, colon);
    }
    if (!is_host(rest)) return not_a_server(text);
    server.host = rest;
    return server;
}

std::vector<std::string_view> parts_of(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

Status check_name(const std::string& name) {
    const bool plain = std::all_of(name.begin(), name.end(), [](char letter) {
        return is_letter_or_digit(letter) || letter == '-' || letter == '_';
    });
    if (plain && !name.empty() && name.size() <= kLongestClusterName) return {};
    return Error{fmt::format("a cluster's name has 1 to {} letters, digits, '-' or '_', found '{}'",
                             kLongestClusterName, name)};
}

// Sets the name unless another one was set before.
Status take_name(const std::string& name, std::string& taken) {
    if (name.empty() || name == taken) return {};
    if (!taken.empty())
        return Error{fmt::format("two different names of the cluster, '{}' and '{}'", taken, name)};
    taken = name;
    return {};
}

}  // namespace

Result<ClusterAddress> cluster_address(const ClusterLogin& login) {
    ClusterAddress address;
    address.credentials = login.credentials;
    address.authority = login.authority;
    address.name = login.name;
    address.on_this_machine = true;
    for (const std::string_view text : parts_of(login.servers)) {
        const Result<Server> server = server_of(text);
        if (!server) return server.error();
        if (!address.servers.empty() && server->encrypted != address.encrypted)
            return Error{"nats:// and tls:// together: either all servers are encrypted or none"};
        if (Status named = take_name(server->cluster, address.name); !named) return named.error();
        address.encrypted = server->encrypted;
        address.on_this_machine = address.on_this_machine && is_loopback(server->host);
        address.servers.push_back(fmt::format("{}{}:{}", server->encrypted ? "tls://" : "nats://",
                                              server->host, server->port));
    }
    if (address.servers.size() > kMostServers)
        return Error{fmt::format("more than {} servers", kMostServers)};
    if (address.name.empty()) address.name = kStandardClusterName;
    if (Status named = check_name(address.name); !named) return named.error();
    if (!address.authority.empty() && !address.encrypted)
        return Error{"a certificate authority is of use to tls:// only, not to nats://"};
    return address;
}

}  // namespace cambrian
