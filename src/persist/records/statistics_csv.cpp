#include "persist/records/statistics_csv.h"

#include "core/text/number_text.h"
#include "persist/records/statistics_columns.h"
#include "persist/sqlite/column_text.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

using Row = GenerationStatistics;

// Returns the founders' uids with the number of children in their lines: "00f3a1b2c4d5e6f7:12
// 9b...:3".
std::string births_text(std::span<const LineBirths> births) {
    std::string text;
    for (const LineBirths& line : births)
        text += fmt::format("{}{}:{}", text.empty() ? "" : " ", hex_text(line.line), line.births);
    return text;
}

}  // namespace

std::string statistics_csv(std::span<const GenerationStatistics> history) {
    std::string text;
    for (const Column<Row>& column : kStatisticsColumns)
        text += std::string(column.name) + ',';
    for (const Column<Row>& column : kLaterStatisticsColumns)
        text += std::string(column.name) + ',';
    text += "terrain_level,trials,births_by_line\n";
    std::int64_t trials = 0;
    for (const Row& row : history) {
        trials += row.evaluations;
        add_cells<Row>(text, row, kStatisticsColumns);
        add_cells<Row>(text, row, kLaterStatisticsColumns);
        text += fmt::format("{},{},{}\n", short_text(row.terrain_level), trials,
                            births_text(row.births));
    }
    return text;
}

}  // namespace cambrian
