#include "core/text/number_rows.h"

#include "core/text/parsed_number.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cambrian {
namespace {

// Removes the first piece of a text, up to a separator, and returns it.
std::string_view take_piece(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view piece = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return piece;
}

std::optional<std::vector<double>> row_in(std::string_view text, std::size_t columns) {
    std::vector<double> numbers;
    while (!text.empty()) {
        const std::string_view word = take_piece(text, ' ');
        if (word.empty()) continue;
        const auto number = parsed_number<double>(word);
        if (!number || !std::isfinite(*number) || numbers.size() == columns) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers.size() == columns ? std::optional(numbers) : std::nullopt;
}

}  // namespace

Result<std::vector<std::vector<double>>> number_rows(std::string_view text,
                                                     const RowFormat& format) {
    std::vector<std::vector<double>> rows;
    while (!text.empty()) {
        const std::string_view piece = take_piece(text, ';');
        if (piece.find_first_not_of(' ') == std::string_view::npos) continue;
        std::optional<std::vector<double>> row = row_in(piece, format.columns);
        if (!row) {
            return Error{fmt::format("{} {} is not {} numbers; expected {}", format.noun,
                                     rows.size() + 1, format.columns, format.expected)};
        }
        rows.push_back(*std::move(row));
        if (rows.size() > format.most)
            return Error{fmt::format("more than {} {}s", format.most, format.noun)};
    }
    return rows;
}

}  // namespace cambrian
