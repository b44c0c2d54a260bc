#include "cluster/connection/credentials.h"

#include "core/files/file_io.h"
#include "persist/json/json_value.h"
#include "persist/settings/toml.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <sys/stat.h>

namespace cambrian {
namespace {

constexpr std::size_t kMostBytes = 65536;
constexpr std::size_t kLongestLogin = 80;
constexpr std::string_view kToken = "-----BEGIN NATS USER JWT-----";
constexpr std::string_view kKey = "-----BEGIN USER NKEY SEED-----";

// The message does not quote the file, which may contain a password.
Error malformed(const std::string& file, const std::string& found) {
    return Error{
        fmt::format("{}: no credentials: expected two lines, user = \"...\" and password = "
                    "\"...\", or a file made by NATS's tools (*.creds); found {}",
                    file, found)};
}

std::string login_of(std::string_view user) {
    std::string login(user.substr(0, kLongestLogin));
    for (char& letter : login) {
        const bool plain = (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
                           (letter >= 'A' && letter <= 'Z') || letter == '-';
        if (!plain) letter = '_';
    }
    return login;
}

// RFC 4648 5, without padding; ends at the first byte that is no letter of it.
std::string from_base64url(std::string_view text) {
    constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    std::string bytes;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char letter : text) {
        const std::size_t value = kLetters.find(letter);
        if (value == std::string_view::npos) break;
        held = (held << 6U) | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<char>((held >> static_cast<unsigned>(bits)) & 0xffU));
    }
    return bytes;
}

// Returns the subject of the signed token, a public key.
std::string subject_of_token(std::string_view text) {
    text.remove_prefix(text.find(kToken));
    text.remove_prefix(std::min(text.find('.') + 1, text.size()));
    const std::string claims = from_base64url(text);
    ErrorList errors;
    const auto root = parse_json(claims, JsonLimits{}, errors);
    const JsonValue* subject =
        root && root->kind == JsonValue::Kind::kObject ? root->find("sub") : nullptr;
    const bool named = subject != nullptr && subject->kind == JsonValue::Kind::kText;
    return named && !subject->text.empty() ? subject->text : "token";
}

}  // namespace

bool others_can_read(const std::string& file) {
    struct stat facts {};
    return ::stat(file.c_str(), &facts) == 0 && (facts.st_mode & (S_IRGRP | S_IROTH)) != 0;
}

Result<Credentials> read_credentials(const std::string& file) {
    const Result<std::string> text = read_file(file, kMostBytes);
    if (!text) return text.error();
    if (text->find(kToken) != std::string::npos) {
        if (text->find(kKey) != std::string::npos) {
            return Credentials{
                .user = {}, .password = {}, .login = login_of(subject_of_token(*text))};
        }
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
    return Credentials{*user, *password, login_of(*user)};
}

}  // namespace cambrian
