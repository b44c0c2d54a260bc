#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Returns 16 hexadecimal digits, the form of uids in files.
std::string hex_text(std::uint64_t number);
// Returns a uid as sixteen hexadecimal digits; empty for 0, which is not a uid.
std::string uid_text(std::uint64_t uid);
std::optional<std::uint64_t> parse_hex(std::string_view text);  // accepts 1 to 16 digits

// Convert between bytes and pairs of lower-case hexadecimal digits.
std::string hex_pairs(std::span<const std::uint8_t> bytes);
std::optional<std::vector<std::uint8_t>> parse_hex_pairs(std::string_view text);
// Returns the number of lines of `line_bytes` bytes that hold `bytes` bytes.
constexpr std::size_t lines_of(std::size_t bytes, std::size_t line_bytes) {
    return (bytes + line_bytes - 1) / line_bytes;
}

// Converts a digest to its form in files: "fnv1a64:5d0c1e0000000001".
std::string digest_text(std::uint64_t digest);
std::optional<std::uint64_t> parse_digest(std::string_view text);

}  // namespace cambrian
