#pragma once

// Texts from other machines made fit to be shown: one line, of bounded length.

#include <cstddef>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::size_t kLongestName = 40;  // bytes, of machines and workers

// Control characters become question marks; what is longer is cut between two characters.
std::string text_for_people(std::string_view text, std::size_t longest);

}  // namespace cambrian
