#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace cambrian {

// Returns a number with its noun: "1 core", "3 cores". The plural must end in s.
inline std::string counted(std::size_t count, std::string_view noun) {
    std::string words = fmt::format("{} {}", count, noun);
    if (count != 1) words += "s";
    return words;
}

}  // namespace cambrian
