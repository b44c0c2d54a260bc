#include "comparison/report.h"

#include <catch2/catch.hpp>

using namespace cambrian;

namespace {

std::vector<ComparedRun> runs_with(const std::string& world, const std::string& arm, double least) {
    std::vector<ComparedRun> runs;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        ComparedRun run;
        run.world = world;
        run.arm = arm;
        run.seed = seed;
        run.confirmed = least * static_cast<double>(seed);
        run.score = run.finer = run.confirmed;
        run.needs_senses = seed > 1 ? 1 : 0;
        runs.push_back(run);
    }
    return runs;
}

void append(std::vector<ComparedRun>& runs, const std::vector<ComparedRun>& more) {
    runs.insert(runs.end(), more.begin(), more.end());
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the report sets every arm against the first", "[comparison]") {
    std::vector<ComparedRun> runs = runs_with("walking", "old", 1.0);
    append(runs, runs_with("walking", "new", 4.0));
    append(runs, runs_with("jumping", "old", 1.0));
    append(runs, runs_with("jumping", "new", 1.0));
    runs.back().finer = 2.0;  // with a score of 3
    const std::string report = comparison_report(runs);
    CHECK(holds(report, "**walking**"));
    CHECK(holds(report, "| old | 3 | 2 | 1 to 3 | 0.5 |  |  |  | 2 | 3 |"));
    // The medians are 8 and 2. All of 4, 8, 12 exceed all of 1, 2, 3: 1 of 20 splits, in either
    // direction.
    CHECK(holds(report, "| new | 3 | 8 | 4 to 12 | 0.5 | 4 | 0.1 | 1 | 8 | 3 |"));
    CHECK(holds(report, "| new | 3 | 2 | 1 to 3 | 0.5 | 1 | 1 | 0.5 | 2 | 2 |"));
    CHECK(holds(report, "| 2 of 3 |"));
    CHECK(holds(report, "- new against old: 2, geometric mean over 2 worlds"));
}

TEST_CASE("arms that are not there yet are left out", "[comparison]") {
    std::vector<ComparedRun> runs = runs_with("walking", "old", 0.0);
    CHECK_FALSE(holds(comparison_report(runs), "against"));
    append(runs, runs_with("jumping", "new", 1.0));
    const std::string report = comparison_report(runs);
    CHECK(holds(report, "| new | 3 |"));
    CHECK_FALSE(holds(report, "against"));
    CHECK(comparison_report({}).empty());
}
