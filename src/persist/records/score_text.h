#pragma once

// A creature's scores in several worlds as text that keeps every bit.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Example: "0.93 0.81 0.99".
std::string scores_text(std::span<const double> scores);

// Returns nothing if the text is not a list of at most 100 finite numbers.
std::optional<std::vector<double>> parse_scores(std::string_view text);

}  // namespace cambrian
