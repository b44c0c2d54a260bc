#pragma once

// Rows of a table as lines of CSV.

#include "core/text/number_text.h"
#include "persist/sqlite/columns.h"

#include <string>

namespace cambrian {

inline std::string cell_text(double number) {
    return real_text(number);
}
inline std::string cell_text(const std::string& text) {
    return text;
}
template <class Whole>
std::string cell_text(Whole number) {
    return std::to_string(number);
}

// Appends the values of a row, each followed by a comma.
template <class Row>
void add_cells(std::string& text, const Row& row, std::span<const Column<Row>> columns) {
    for (const Column<Row>& column : columns) {
        text += std::visit([&row](auto field) { return cell_text(row.*field); }, column.field);
        text += ',';
    }
}

}  // namespace cambrian
