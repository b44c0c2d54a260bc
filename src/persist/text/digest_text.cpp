#include "persist/text/digest_text.h"

#include <charconv>

namespace cambrian {
namespace {

constexpr std::string_view kDigestPrefix = "fnv1a64:";
constexpr std::size_t kDigestDigits = 16;
constexpr std::string_view kHexDigits = "0123456789abcdef";

}  // namespace

std::string hex_text(std::uint64_t number) {
    std::string text(kDigestDigits, '0');
    for (std::size_t i = kDigestDigits; i-- > 0; number >>= 4)
        text[i] = kHexDigits[number & 15];
    return text;
}

std::string uid_text(std::uint64_t uid) {
    return uid == 0 ? std::string() : hex_text(uid);
}

std::optional<std::uint64_t> parse_hex(std::string_view text) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, number, 16);
    if (failure != std::errc() || stop != end || text.size() > kDigestDigits) return std::nullopt;
    return number;
}

std::string hex_pairs(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += kHexDigits[byte >> 4];
        text += kHexDigits[byte & 15];
    }
    return text;
}

std::optional<std::vector<std::uint8_t>> parse_hex_pairs(std::string_view text) {
    if (text.size() % 2 != 0) return std::nullopt;
    std::vector<std::uint8_t> bytes(text.size() / 2);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t digit = kHexDigits.find(text[i]);
        if (digit == std::string_view::npos) return std::nullopt;
        bytes[i / 2] = static_cast<std::uint8_t>(bytes[i / 2] * std::size_t{16} + digit);
    }
    return bytes;
}

std::string digest_text(std::uint64_t digest) {
    return std::string(kDigestPrefix) + hex_text(digest);
}

std::optional<std::uint64_t> parse_digest(std::string_view text) {
    if (text.substr(0, kDigestPrefix.size()) != kDigestPrefix) return std::nullopt;
    return parse_hex(text.substr(kDigestPrefix.size()));
}

}  // namespace cambrian
