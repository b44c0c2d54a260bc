#pragma once

// The members of a plain struct as columns of a table, for SQL and CSV.

#include "persist/sqlite/database.h"

#include <fmt/core.h>

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <variant>

namespace cambrian {

// The form of a number in CSV.
enum class CellForm : std::uint8_t { kPlain, kUid };

template <class Row>
struct Column {
    const char* name;
    std::variant<int Row::*, std::uint32_t Row::*, std::uint64_t Row::*, double Row::*, bool Row::*,
                 std::string Row::*>
        field;
    CellForm form = CellForm::kPlain;
};

template <class Row>
void bind_columns(Statement& statement, std::span<const Column<Row>> columns, const Row& row) {
    for (const Column<Row>& column : columns)
        std::visit([&](auto field) { statement.bind_next(row.*field); }, column.field);
}

inline void read_column(const Statement& statement, int column, double& place) {
    place = statement.real(column);
}
inline void read_column(const Statement& statement, int column, std::string& place) {
    place = statement.word(column);
}
inline void read_column(const Statement& statement, int column, std::uint64_t& place) {
    place = static_cast<std::uint64_t>(statement.integer(column));
}
inline void read_column(const Statement& statement, int column, bool& place) {
    place = statement.integer(column) != 0;
}
template <class Whole>
void read_column(const Statement& statement, int column, Whole& place) {
    const std::int64_t number = statement.integer(column);
    if (number < std::numeric_limits<Whole>::min() || number > std::numeric_limits<Whole>::max())
        throw DatabaseError(fmt::format("{} is too large or too small", number));
    place = static_cast<Whole>(number);
}

// Reads the columns from `first` on; returns the number of the column after the last.
template <class Row>
int read_columns(const Statement& statement, int first, std::span<const Column<Row>> columns,
                 Row& row) {
    for (const Column<Row>& column : columns) {
        std::visit([&](auto field) { read_column(statement, first, row.*field); }, column.field);
        ++first;
    }
    return first;
}

// Returns "best, fitness REAL, ..." for CREATE TABLE. Columns of doubles have no declared type,
// because SQLite would then store -0.0 as 0.0.
template <class Row>
std::string column_definitions(std::span<const Column<Row>> columns) {
    std::string text;
    for (const Column<Row>& column : columns) {
        text += std::string(text.empty() ? "" : ", ") + column.name;
        if (std::holds_alternative<std::string Row::*>(column.field)) {
            text += " TEXT NOT NULL";
        } else if (!std::holds_alternative<double Row::*>(column.field)) {
            text += " INTEGER NOT NULL";
        }
    }
    return text;
}

template <class Row>
std::string column_names(std::span<const Column<Row>> columns) {
    std::string text;
    for (const Column<Row>& column : columns)
        text += std::string(text.empty() ? "" : ", ") + column.name;
    return text;
}

// Returns ", ?, ?, ...".
inline std::string more_places(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += ", ?";
    return text;
}

}  // namespace cambrian
