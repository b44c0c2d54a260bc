#include "cluster/connection/credentials.h"

#include "support/temporary_directory.h"

#include <catch2/catch.hpp>

using namespace cambrian;

namespace {

Result<Credentials> read(std::string_view text) {
    const TemporaryDirectory folder;
    const auto file = folder / "me.credentials";
    std::ofstream(file) << text;
    return read_credentials(file);
}

}  // namespace

TEST_CASE("a user and a password are read") {
    const auto credentials = read("# of the lab\nuser = \"worker\"\npassword = \"s3cret\"\n");
    REQUIRE(credentials);
    CHECK(credentials->user == "worker");
    CHECK(credentials->password == "s3cret");
    CHECK(credentials->login == "worker");
    CHECK(read("user = \"lab.two >\"\npassword = \"s\"\n")->login == "lab_two__");
}

TEST_CASE("a file of NATS's tools is left to the connection") {
    const auto credentials = read(
        "-----BEGIN NATS USER JWT-----\neyJ0\n------END NATS USER JWT------\n"
        "-----BEGIN USER NKEY SEED-----\nSUAB\n------END USER NKEY SEED------\n");
    REQUIRE(credentials);
    CHECK(credentials->user.empty());
    CHECK(credentials->login == "token");
    // {"sub": "UABC"}
    CHECK(read("-----BEGIN NATS USER JWT-----\neyJ0.eyJzdWIiOiAiVUFCQyJ9.c2ln\n"
               "------END NATS USER JWT------\n-----BEGIN USER NKEY SEED-----\nSUAB\n")
              ->login == "UABC");
}

TEST_CASE("what are no credentials is refused without quoting them") {
    for (const char* text :
         {"", "user = \"worker\"\n", "user = \"worker\"\npassword = \"\"\n",
          "user = \"worker\"\npassword = s3cret\n", "user = 1\npassword = \"s3cret\"\n",
          "user = \"w\"\npassword = \"s3cret\"\nport = 1\n", "\x00\xff s3cret",
          "-----BEGIN NATS USER JWT-----\ns3cret\n------END NATS USER JWT------\n"}) {
        INFO(text);
        const auto credentials = read(text);
        REQUIRE_FALSE(credentials);
        CHECK(credentials.error().message.find("me.credentials: no credentials") !=
              std::string::npos);
        CHECK(credentials.error().message.find("s3cret") == std::string::npos);
    }
}

TEST_CASE("credentials that are missing name the file") {
    const auto credentials = read_credentials("/nowhere/me.credentials");
    REQUIRE_FALSE(credentials);
    CHECK(credentials.error().message.find("/nowhere/me.credentials") != std::string::npos);
}
