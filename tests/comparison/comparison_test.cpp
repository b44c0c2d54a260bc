#include "comparison/comparison.h"

#include "comparison/plan.h"
#include "comparison/run_table.h"
#include "evolution/backends/thread_pool_backend.h"
#include "persist/creature/creature_file.h"
#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <mutex>

using namespace cambrian;
using namespace cambrian::test;

namespace {

constexpr const char* kShort =
    "[goal]\nbehavior = \"swimming\"\n[population]\nsize = 12\n[trial]\nduration = 2.0\n";

std::vector<PlannedRun> small_plan(int trials = 30) {
    const auto runs = planned_runs({.arms = {{"plain", {{kShort, "plain.toml"}}}},
                                    .random_search = true,
                                    .seeds = {1, 2},
                                    .trials = trials},
                                   kinds());
    REQUIRE(runs);
    return *runs;
}

Result<std::unique_ptr<EvaluationBackend>> own_core() {
    return make_thread_pool_backend(kinds(), 1);
}

// Returns the run without the time it took.
ComparedRun timeless(ComparedRun run) {
    run.seconds = 0.0;
    return run;
}

std::vector<ComparedRun> rows_of(const std::filesystem::path& folder, std::size_t threads,
                                 int* told = nullptr) {
    const auto comparison = Comparison::open(folder, small_plan(), kinds());
    REQUIRE(comparison);
    REQUIRE((*comparison)
                ->run(threads, own_core,
                      [told](const ComparedRun&) {
                          if (told != nullptr) ++*told;
                      },
                      {}));
    CHECK((*comparison)->share_done() == 1.0);
    std::vector<ComparedRun> rows = (*comparison)->finished();
    std::transform(rows.begin(), rows.end(), rows.begin(), timeless);
    return rows;
}

}  // namespace

TEST_CASE("runs come to the same on any number of threads", "[comparison]") {
    const TemporaryDirectory one;
    const TemporaryDirectory two;
    const std::vector<ComparedRun> rows = rows_of(one.path(), 1);
    REQUIRE(rows.size() == 4);
    CHECK(rows == rows_of(two.path(), 2));
    for (const ComparedRun& row : rows) {
        CHECK(row.evaluations >= 30);
        CHECK(row.curve.back() == CurvePoint{row.evaluations, row.curve.back().score});
        CHECK(row.curve.size() == static_cast<std::size_t>(row.generations));
        CHECK(row.plans >= 1);
    }
    CHECK(rows[0].arm == "plain");
    CHECK(rows[1].arm == kRandomSearch);
    CHECK(rows[0].settings != rows[1].settings);
}

TEST_CASE("what is finished is not run again, unless it would come to something else",
          "[comparison]") {
    const TemporaryDirectory folder;
    int told = 0;
    const std::vector<ComparedRun> rows = rows_of(folder.path(), 2, &told);
    CHECK(told == 4);
    CHECK(rows_of(folder.path(), 2, &told) == rows);
    CHECK(told == 4);
    const auto longer = Comparison::open(folder.path(), small_plan(60), kinds());
    REQUIRE(longer);
    CHECK((*longer)->missing() == 4);
    auto table = load_run_table(folder / "runs.csv");
    REQUIRE(table);
    table->front().simulator = "0.9";
    put_text(folder / "runs.csv", run_table_csv(*table));
    const auto other = Comparison::open(folder.path(), small_plan(), kinds());
    REQUIRE(other);
    CHECK((*other)->missing() == 1);
}

TEST_CASE("the champion of every run is kept and scores what the table says", "[comparison]") {
    const TemporaryDirectory folder;
    for (const ComparedRun& row : rows_of(folder.path(), 2)) {
        const auto champion = load_creature(champion_file(folder.path(), row), kinds());
        REQUIRE(champion);
        CHECK(champion->score() == row.score);  // swimming has no confirmation
    }
}

TEST_CASE("a comparison that is stopped keeps what has finished", "[comparison]") {
    const TemporaryDirectory folder;
    const auto comparison = Comparison::open(folder.path(), small_plan(), kinds());
    REQUIRE(comparison);
    std::stop_source stop;
    REQUIRE((*comparison)
                ->run(
                    1, own_core, [&stop](const ComparedRun&) { stop.request_stop(); },
                    stop.get_token()));
    CHECK((*comparison)->finished().size() == 1);
    const auto table = load_run_table(folder / "runs.csv");
    REQUIRE(table);
    CHECK(table->size() == 1);
}

TEST_CASE("a back-end that cannot be made or go on ends the comparison with its reason",
          "[comparison]") {
    const auto failure_with = [](const BackendMaking& make) {
        const TemporaryDirectory folder;
        const auto comparison = Comparison::open(folder.path(), small_plan(), kinds());
        REQUIRE(comparison);
        const Status ran = (*comparison)->run(2, make, [](const ComparedRun&) {}, {});
        REQUIRE_FALSE(ran);
        CHECK((*comparison)->finished().empty());
        return ran.error().message;
    };
    CHECK(failure_with([]() -> Result<std::unique_ptr<EvaluationBackend>> {
              return Error{"no host has the name lab"};
          }) == "no host has the name lab");
    CHECK(failure_with([]() -> Result<std::unique_ptr<EvaluationBackend>> {
              auto backend = std::make_unique<FakeBackend>();
              backend->failure = "two workers with other bits";
              backend->most_a_call = 0;
              return std::unique_ptr<EvaluationBackend>(std::move(backend));
          }) == "two workers with other bits");
}

TEST_CASE("a folder whose table is another file is left alone", "[comparison]") {
    const TemporaryDirectory folder;
    put_text(folder / "runs.csv", "mine\n");
    CHECK_FALSE(Comparison::open(folder.path(), small_plan(), kinds()));
    CHECK(get_text(folder / "runs.csv") == "mine\n");
}
