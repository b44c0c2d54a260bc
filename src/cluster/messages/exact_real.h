#pragma once

// Real numbers in messages, with every bit. JSON has no infinities and no NaN, so their bits are
// written under another key.

#include "persist/json/json_reader.h"
#include "persist/json/json_writer.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

namespace cambrian {

inline std::string bits_key(const char* key) {
    return std::string(key) + "Bits";
}

inline void exact_real(JsonWriter& writer, const char* key, double value) {
    if (std::isfinite(value))
        writer.plain_real(key, value);
    else
        writer.digest(bits_key(key).c_str(), std::bit_cast<std::uint64_t>(value));
}

inline void exact_real(JsonReader& reader, const char* key, double& value) {
    if (!reader.has(bits_key(key).c_str())) return reader.plain_real(key, value);
    std::uint64_t bits = 0;
    reader.digest(bits_key(key).c_str(), bits);
    value = std::bit_cast<double>(bits);
}

}  // namespace cambrian
