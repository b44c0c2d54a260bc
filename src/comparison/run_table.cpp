#include "comparison/run_table.h"

#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "core/text/parsed_number.h"
#include "core/text/shown_text.h"
#include "persist/sqlite/column_text.h"

#include <fmt/core.h>

#include <array>
#include <sstream>
#include <type_traits>
#include <variant>

namespace cambrian {
namespace {

using Row = ComparedRun;
constexpr std::size_t kMaxBytes = 256'000'000;

constexpr std::array kColumns = {
    Column<Row>{"world", &Row::world},
    Column<Row>{"arm", &Row::arm},
    Column<Row>{"seed", &Row::seed},
    Column<Row>{"trials", &Row::trials},
    Column<Row>{"settings", &Row::settings},
    Column<Row>{"simulator", &Row::simulator},
    Column<Row>{"score", &Row::score},
    Column<Row>{"confirmed", &Row::confirmed},
    Column<Row>{"finer", &Row::finer},
    Column<Row>{"jump_height", &Row::jump_height},
    Column<Row>{"parts", &Row::parts},
    Column<Row>{"needs_senses", &Row::needs_senses},
    Column<Row>{"lines", &Row::lines},
    Column<Row>{"plans", &Row::plans},
    Column<Row>{"generations", &Row::generations},
    Column<Row>{"evaluations", &Row::evaluations},
    Column<Row>{"audited", &Row::audited},
    Column<Row>{"audited_survivors", &Row::survivors},
    Column<Row>{"time_saved", &Row::time_saved},
    Column<Row>{"core_seconds", &Row::seconds},
};
constexpr const char* kCurve = "curve";

std::string header() {
    std::string text;
    for (const Column<Row>& column : kColumns)
        text += std::string(column.name) + ',';
    return text + kCurve;
}

// Returns the text before the separator and removes both from `text`.
std::string_view take(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view first = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return first;
}

bool read_curve(std::string_view text, std::vector<CurvePoint>& curve) {
    while (!text.empty()) {
        std::string_view point = take(text, ' ');
        CurvePoint& next = curve.emplace_back();
        if (!read_cell(take(point, ':'), next.trials) || !read_cell(point, next.score))
            return false;
    }
    return true;
}

bool read_row(std::string_view line, Row& row) {
    return take_cells<Row>(line, kColumns, row) && read_curve(line, row.curve);
}

}  // namespace

std::string run_table_csv(const std::vector<ComparedRun>& runs) {
    std::string text = header() + '\n';
    for (const Row& row : runs) {
        add_cells<Row>(text, row, kColumns);
        std::string curve;
        for (const CurvePoint& point : row.curve)
            curve += fmt::format("{}{}:{}", curve.empty() ? "" : " ", point.trials,
                                 real_text(point.score));
        text += curve + '\n';
    }
    return text;
}

Result<std::vector<ComparedRun>> parse_run_table(std::string_view text, std::string_view source) {
    const auto refusal = [&](int line, const std::string& what) {
        return Error{fmt::format("{}: line {}: {}", source, line, what)};
    };
    if (take(text, '\n') != header()) return refusal(1, "expected a table of compared runs");
    std::vector<ComparedRun> runs;
    for (int line = 2; !text.empty(); ++line) {
        Row row;
        const bool whole = text.find('\n') != std::string_view::npos;
        if (!whole || !read_row(take(text, '\n'), row)) return refusal(line, "is no run");
        runs.push_back(std::move(row));
    }
    return runs;
}

Result<std::vector<ComparedRun>> load_run_table(const std::filesystem::path& path) {
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) return std::vector<ComparedRun>();
    const Result<std::string> text = read_file(path, kMaxBytes);
    if (!text) return text.error();
    return parse_run_table(*text, path.string());
}

}  // namespace cambrian
