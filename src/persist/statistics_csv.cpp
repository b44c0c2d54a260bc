#include "persist/statistics_csv.h"

#include "core/text/number_text.h"
#include "persist/statistics_columns.h"

#include <variant>

namespace cambrian {
namespace {

using Row = GenerationStatistics;

std::string number_text(double number) {
    return real_text(number);
}
std::string number_text(const std::string& text) {
    return text;
}
template <class Whole>
std::string number_text(Whole number) {
    return std::to_string(number);
}

}  // namespace

std::string statistics_csv(std::span<const GenerationStatistics> history) {
    std::string text;
    for (const Column<Row>& column : kStatisticsColumns) {
        if (!text.empty()) text += ',';
        text += column.name;
    }
    text += '\n';
    for (const Row& row : history) {
        for (const Column<Row>& column : kStatisticsColumns) {
            if (&column != kStatisticsColumns.data()) text += ',';
            text +=
                std::visit([&row](auto field) { return number_text(row.*field); }, column.field);
        }
        text += '\n';
    }
    return text;
}

}  // namespace cambrian
