#pragma once

// Scores of a creature in several worlds as words of a table, which keep every bit.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// "0.93 0.81 0.99"
std::string scores_text(std::span<const double> scores);

// None if it is not such a text of finite numbers, 100 at most.
std::optional<std::vector<double>> parse_scores(std::string_view text);

}  // namespace cambrian
