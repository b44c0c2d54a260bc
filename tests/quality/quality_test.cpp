// Tests the criteria of the benchmark on cases whose result is known.

#include "app/builtin_kinds.h"
#include "core/files/file_io.h"
#include "quality/arm.h"
#include "quality/criteria.h"
#include "quality/plan.h"
#include "quality/report.h"
#include "quality/run_table.h"
#include "support/temporary_directory.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace cambrian;
using namespace cambrian::quality;

namespace {

RunResult run_with(const char* goal, std::string_view arm, std::uint64_t seed, double best) {
    RunResult run;
    static_cast<RunSpec&>(run) = {
        .plan = "standard", .goal = goal, .arm = std::string(arm), .seed = seed, .budget = 3000};
    run.best = run.final_best = run.finer = best;
    run.late_travel = 1.0;
    return run;
}

Finding finding_of(const std::vector<Criterion>& criteria, const std::string& id,
                   const std::string& word) {
    const auto found =
        std::find_if(criteria.begin(), criteria.end(), [&](const Criterion& criterion) {
            return criterion.id == id && criterion.asked.find(word) != std::string::npos;
        });
    REQUIRE(found != criteria.end());
    return found->finding;
}

}  // namespace

TEST_CASE("runs are written and read, and a torn line is not", "[quality]") {
    RunResult run = run_with("walking", kEvolution, 7, 0.1 + 0.2);
    run.evaluations = 3001;
    run.digest = 0xFEDCBA9876543210U;
    run.clean = true;
    run.offspring["grafting"] = {120, 3};
    const TemporaryDirectory folder;
    const auto path = folder.path() / "runs.csv";
    const std::string line = run_line(run);
    REQUIRE(write_file(path, run_header() + line + line.substr(0, line.size() / 2)));
    const auto read = read_runs(path);
    REQUIRE(read);
    REQUIRE(read->size() == 1);
    const RunResult& back = read->front();
    CHECK(back.goal == "walking");
    CHECK(back.seed == 7);
    CHECK(back.best == run.best);
    CHECK(back.digest == run.digest);
    CHECK(back.clean);
    CHECK(back.offspring.at("grafting").born == 120);
    CHECK(run_line(back) == line);
}

TEST_CASE("plans name known goals and arms, and no run twice", "[quality]") {
    const EvolutionKinds kinds = builtin_kinds();
    for (const char* plan : {"standard", "long", "quick", "seeking"}) {
        const std::vector<RunSpec> runs = plan_of(plan);
        CHECK_FALSE(runs.empty());
        std::vector<std::string> names;
        for (const RunSpec& run : runs) {
            CHECK(kinds.goals.find(run.goal) != nullptr);
            CHECK(arm_of(run.arm).id == run.arm);
            names.push_back(run.goal + run.arm + std::to_string(run.seed));
        }
        std::sort(names.begin(), names.end());
        CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    }
    CHECK(plan_of("no such plan").empty());
}

TEST_CASE("criteria hold, fail or are not run, as the runs say", "[quality]") {
    std::vector<RunResult> runs;
    CHECK(finding_of(standard_criteria(runs), "B1", "walking") == Finding::kNotRun);
    for (std::uint64_t seed = 1; seed <= 9; ++seed) {
        const auto step = 0.001 * static_cast<double>(seed);
        runs.push_back(run_with("walking", kEvolution, seed, 0.9 + step));
        runs.push_back(run_with("walking", kRandomSearch, seed, 0.4 + step));
        runs.push_back(run_with("swimming", kEvolution, seed, 0.7 + step));
        runs.push_back(run_with("swimming", kRandomSearch, seed, 0.4 + step));
    }
    runs[0].late_travel = 0.01;
    const std::vector<Criterion> criteria = standard_criteria(runs);
    CHECK(finding_of(criteria, "B1", "walking") == Finding::kHolds);
    // 1.75 times, less than the required 2.
    CHECK(finding_of(criteria, "B1", "swimming") == Finding::kFails);
    CHECK(finding_of(criteria, "B1", "jumping") == Finding::kNotRun);
    CHECK(finding_of(criteria, "B2", "walking") == Finding::kHolds);
    CHECK(finding_of(criteria, "B6", "walking") == Finding::kFails);
    CHECK(finding_of(criteria, "B7", "walking") == Finding::kHolds);
    CHECK(finding_of(criteria, "B8", "the same run") == Finding::kNotRun);
    const std::string page = criteria_table(criteria) + arm_tables(runs, "standard");
    CHECK(page.find("0.905 against 0.405") != std::string::npos);
}

TEST_CASE("a short run of every arm is complete and repeats", "[quality]") {
    const EvolutionKinds kinds = builtin_kinds();
    for (const Arm& arm : all_arms()) {
        const RunSpec spec = {.plan = "test",
                              .goal = "swimming",
                              .arm = std::string(arm.id),
                              .seed = 3,
                              .size = 12,
                              .budget = 24,
                              .most_generations = 6};
        const RunResult run = perform(spec, kinds, {}).value();
        INFO(arm.id);
        CHECK(run.evaluations > 0);
        CHECK(run.generations <= 6);
        CHECK(run.curve.size() == static_cast<std::size_t>(run.generations));
        CHECK(run.final_best >= run.best);
        CHECK_FALSE(run.decreased);
        CHECK(run.cells > 0);
        CHECK(perform(spec, kinds, {}).value().digest == run.digest);
    }
}
