#pragma once

// Rows of a table as lines of CSV.

#include "core/text/number_text.h"
#include "core/text/parsed_number.h"
#include "core/text/shown_text.h"
#include "persist/sqlite/columns.h"
#include "persist/text/digest_text.h"

#include <cstdint>
#include <string>
#include <string_view>
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

inline bool read_cell(std::string_view cell, std::string& text) {
    text = text_of_csv_cell(cell);
    return true;
}
inline bool read_cell(std::string_view cell, bool& flag) {
    flag = cell == "1";
    return flag || cell == "0";
}
template <class Number>
bool read_cell(std::string_view cell, Number& number) {
    const auto read = parsed_number<Number>(cell);
    number = read.value_or(number);
    return read.has_value();
}
template <class Value>
bool read_cell(std::string_view cell, Value& value, CellForm form) {
    if constexpr (std::is_same_v<Value, std::uint64_t>) {
        if (form == CellForm::kUid) {
            value = parse_hex(cell).value_or(0);
            return cell == uid_text(value);
        }
    }
    return read_cell(cell, value);
}

// Takes a row's values, which add_cells() wrote, from the start of a line. Returns false if they
// are not there.
template <class Row>
bool take_cells(std::string_view& line, std::span<const Column<Row>> columns, Row& row) {
    for (const Column<Row>& column : columns) {
        if (line.empty()) return false;
        const std::string_view cell = take_csv_cell(line);
        if (!std::visit([&](auto field) { return read_cell(cell, row.*field, column.form); },
                        column.field))
            return false;
    }
    return true;
}

}  // namespace cambrian
