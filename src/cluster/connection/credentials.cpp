#include "cluster/connection/credentials.h"

#include "core/files/file_io.h"
#include "persist/settings/toml.h"

#include <fmt/core.h>

#include <string_view>

namespace cambrian {
namespace {

constexpr std::size_t kMostBytes = 65536;
constexpr std::string_view kToken = "-----BEGIN NATS USER JWT-----";
constexpr std::string_view kKey = "-----BEGIN USER NKEY SEED-----";

// The message does not quote the file, which may contain a password.
Error malformed(const std::string& file, const std::string& found) {
    return Error{
        fmt::format("{}: no credentials: expected two lines, user = \"...\" and password = "
                    "\"...\", or a file made by NATS's tools (*.creds); found {}",
                    file, found)};
}

}  // namespace

Result<Credentials> read_credentials(const std::string& file) {
    const Result<std::string> text = read_file(file, kMostBytes);
    if (!text) return text.error();
    if (text->find(kToken) != std::string::npos) {
        if (text->find(kKey) != std::string::npos) return Credentials{};
        return malformed(file, "a token without its key");
    }
    const toml::parse_result document = parse_toml(*text);
    if (!document) {
        return malformed(
            file, fmt::format("something else in line {}", document.error().source().begin.line));
    }
    const auto user = document["user"].value<std::string>();
    const auto password = document["password"].value<std::string>();
    if (!user || user->empty() || !password || password->empty())
        return malformed(file, "no user or no password");
    if (document.table().size() != 2) return malformed(file, "other keys besides");
    return Credentials{*user, *password};
}

}  // namespace cambrian
