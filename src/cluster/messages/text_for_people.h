#pragma once

// Makes texts from other machines fit for display: one line of limited length.

#include <cstddef>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::size_t kLongestName = 40;  // bytes of a name of a machine or worker

// Control characters become question marks; longer text is cut between two characters.
std::string text_for_people(std::string_view text, std::size_t longest);

}  // namespace cambrian
