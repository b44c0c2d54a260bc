#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// 16 hexadecimal digits, as uids are written.
std::string hex_text(std::uint64_t number);
// The same of a creature's uid; empty for 0, which is nobody's.
std::string uid_text(std::uint64_t uid);
std::optional<std::uint64_t> parse_hex(std::string_view text);  // 1 to 16 digits

// Bytes as pairs of lower-case hexadecimal digits.
std::string hex_pairs(std::span<const std::uint8_t> bytes);
std::optional<std::vector<std::uint8_t>> parse_hex_pairs(std::string_view text);
// How many texts of so many bytes each hold them all.
constexpr std::size_t lines_of(std::size_t bytes, std::size_t line_bytes) {
    return (bytes + line_bytes - 1) / line_bytes;
}

// A digest as written to files: "fnv1a64:5d0c1e0000000001".
std::string digest_text(std::uint64_t digest);
std::optional<std::uint64_t> parse_digest(std::string_view text);

}  // namespace cambrian
