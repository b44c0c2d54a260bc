#pragma once

// Rows of a table as lines of CSV.

#include "core/text/number_text.h"
#include "core/text/shown_text.h"
#include "persist/sqlite/columns.h"
#include "persist/text/digest_text.h"

#include <string>
#include <type_traits>

namespace cambrian {

inline std::string cell_text(double number) {
    return real_text(number);
}
inline std::string cell_text(const std::string& text) {
    return csv_cell(text);
}
template <class Whole>
std::string cell_text(Whole number) {
    return std::to_string(number);
}
// Uids are written as in creature files.
template <class Value>
std::string cell_text(const Value& value, CellForm form) {
    if constexpr (std::is_same_v<Value, std::uint64_t>) {
        if (form == CellForm::kUid) return uid_text(value);
    }
    return cell_text(value);
}

// Appends the values of a row, each followed by a comma.
template <class Row>
void add_cells(std::string& text, const Row& row, std::span<const Column<Row>> columns) {
    for (const Column<Row>& column : columns) {
        text += std::visit([&](auto field) { return cell_text(row.*field, column.form); },
                           column.field);
        text += ',';
    }
}

}  // namespace cambrian
