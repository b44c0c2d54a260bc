#include "persist/records/statistics_csv.h"

#include "support/catch.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace cambrian {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream rest(line);
    for (std::string cell; std::getline(rest, cell, ',');)
        cells.push_back(cell);
    return cells;
}

std::vector<std::vector<std::string>> table_of(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        rows.push_back(cells_of(line));
    return rows;
}

// Returns a row in which every field has a different value. It does not compile when a field is
// added, as a reminder to test and write that field.
GenerationStatistics numbered_row() {
    GenerationStatistics row;
    auto& [generation, size, evaluations, confirmations, best, lowest, highest, upper, median,
           lower, mean, invalid, parts, neurons, distinct, lines, plans, births, rejected, reused,
           rested, given_up, distrusted, saved, cells, level, quality, idle, mark] = row;
    double next = 101.0;
    const auto number = [&next](auto&... fields) {
        ((fields = static_cast<std::remove_reference_t<decltype(fields)>>(next++)), ...);
    };
    number(generation, size, evaluations, confirmations, best, lowest, highest, upper, median,
           lower, mean, invalid, parts, neurons, distinct, lines, plans, rejected, reused, rested,
           given_up, saved, cells, level, quality, idle, mark);
    distrusted = true;
    births = {{0xab, 30}, {0x1234567890abcdef, 2}};
    return row;
}

TEST_CASE("every field of the statistics has a named column", "[persist][statistics_csv]") {
    const auto table = table_of(statistics_csv(std::vector{numbered_row()}));
    REQUIRE(table.size() == 2);
    CHECK(table[0].front() == "generation");
    REQUIRE(table[0].size() == 30);
    REQUIRE(table[1].size() == 30);
    CHECK(table[0].back() == "births_by_line");
    CHECK(table[0][28] == "trials");
    CHECK(table[1][28] == "103");  // the evaluations of the only row
    CHECK(table[1].back() == "00000000000000ab:30 1234567890abcdef:2");
    std::vector<double> found;
    for (std::size_t i = 0; i + 2 < table[1].size(); ++i)
        found.push_back(std::strtod(table[1][i].c_str(), nullptr));
    std::sort(found.begin(), found.end());
    CHECK(found.front() == 1.0);  // true
    for (std::size_t i = 1; i < found.size(); ++i)
        CHECK(found[i] == 100.0 + static_cast<double>(i));
}

TEST_CASE("numbers of the statistics read back to the same bits", "[persist][statistics_csv]") {
    const std::vector<double> awkward = {0.1,    -0.0, 1.0 / 3.0, 1e300,
                                         5e-324, 1e-5, -2.5e17,   123456789.123456789};
    std::vector<GenerationStatistics> history;
    for (const double value : awkward) {
        GenerationStatistics row;
        row.generation = static_cast<std::uint32_t>(history.size());
        row.best = value;
        row.quality = -value;
        history.push_back(row);
    }
    const auto table = table_of(statistics_csv(history));
    REQUIRE(table.size() == awkward.size() + 1);
    const auto column = [&](const char* name) {
        return static_cast<std::size_t>(std::find(table[0].begin(), table[0].end(), name) -
                                        table[0].begin());
    };
    for (std::size_t i = 0; i < awkward.size(); ++i) {
        const double best = std::strtod(table[i + 1].at(column("best")).c_str(), nullptr);
        const double quality = std::strtod(table[i + 1].at(column("quality")).c_str(), nullptr);
        CHECK(std::bit_cast<std::uint64_t>(best) == std::bit_cast<std::uint64_t>(awkward[i]));
        CHECK(std::bit_cast<std::uint64_t>(quality) == std::bit_cast<std::uint64_t>(-awkward[i]));
        CHECK(table[i + 1].at(column("generation")) == std::to_string(i));
    }
}

TEST_CASE("a run without generations is a header alone", "[persist][statistics_csv]") {
    CHECK(table_of(statistics_csv({})).size() == 1);
}

}  // namespace
}  // namespace cambrian
