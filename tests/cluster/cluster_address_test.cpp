#include "cluster/connection/cluster_address.h"

#include <catch2/catch.hpp>

using namespace cambrian;

namespace {

std::string refusal(const ClusterLogin& login) {
    const auto address = cluster_address(login);
    return address ? "" : address.error().message;
}

}  // namespace

TEST_CASE("an address gets the standard port and name") {
    const auto address = cluster_address({.servers = "nats://lab-server"});
    REQUIRE(address);
    CHECK(address->servers == std::vector<std::string>{"nats://lab-server:4222"});
    CHECK(address->name == "cambrian");
    CHECK_FALSE(address->encrypted);
    CHECK_FALSE(address->on_this_machine);
}

TEST_CASE("several servers are one cluster, named by option or path") {
    const auto address =
        cluster_address({.servers = "tls://a:1/lab,tls://[::1]:65535", .name = "lab"});
    REQUIRE(address);
    CHECK(address->servers == std::vector<std::string>{"tls://a:1", "tls://[::1]:65535"});
    CHECK(address->name == "lab");
    CHECK(address->encrypted);
}

TEST_CASE("only loopback addresses are on this machine") {
    CHECK(cluster_address({.servers = "nats://localhost,nats://127.0.0.1:5,nats://[::1]"})
              ->on_this_machine);
    CHECK_FALSE(cluster_address({.servers = "nats://localhost,nats://lab"})->on_this_machine);
    CHECK_FALSE(cluster_address({.servers = "nats://127.evil.invalid"})->on_this_machine);
}

TEST_CASE("an invalid address is refused with a message") {
    for (const char* servers :
         {"", "lab-server", "http://lab", "nats://", "nats://lab:0", "nats://lab:65536",
          "nats://lab:", "nats://lab:4222x", "nats://la b", "nats://[::1", "nats://a,,nats://b",
          "nats://a/b c", "nats://\n", "NATS://lab"}) {
        INFO(servers);
        CHECK_FALSE(refusal({.servers = servers}).empty());
    }
    CHECK(refusal({.servers = "lab"}).find("nats://HOST") != std::string::npos);
    CHECK(refusal({.servers = "nats://a,tls://b"}).find("together") != std::string::npos);
}

TEST_CASE("a password in an address is refused and not repeated") {
    const std::string words = refusal({.servers = "nats://me:secret@lab"});
    CHECK(words.find("--credentials") != std::string::npos);
    CHECK(words.find("secret") == std::string::npos);
}

TEST_CASE("two names of one cluster are refused") {
    for (const ClusterLogin& login : {ClusterLogin{.servers = "nats://a/one,nats://b/two"},
                                      ClusterLogin{.servers = "nats://a/one", .name = "two"}}) {
        const std::string words = refusal(login);
        CHECK(words.find("'one'") != std::string::npos);
        CHECK(words.find("'two'") != std::string::npos);
    }
}

TEST_CASE("a cluster's name is a plain word") {
    CHECK(cluster_address({.servers = "nats://a", .name = "Lab_2-b"}));
    for (const std::string& name :
         {std::string("a.b"), std::string("*"), std::string(">"), std::string(41, 'a')})
        CHECK(refusal({.servers = "nats://a", .name = name}).find("name") != std::string::npos);
}

TEST_CASE("an authority is of no use without encryption") {
    CHECK_FALSE(refusal({.servers = "nats://a", .authority = "ca.pem"}).empty());
    CHECK(refusal({.servers = "tls://a", .authority = "ca.pem"}).empty());
}
