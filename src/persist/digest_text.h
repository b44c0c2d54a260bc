#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cambrian {

// 16 hexadecimal digits, as uids are written.
std::string hex_text(std::uint64_t number);
std::optional<std::uint64_t> parse_hex(std::string_view text);  // 1 to 16 digits

// A digest as written to files: "fnv1a64:5d0c1e0000000001".
std::string digest_text(std::uint64_t digest);
std::optional<std::uint64_t> parse_digest(std::string_view text);

}  // namespace cambrian
