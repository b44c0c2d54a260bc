#include "core/files/file_io.h"
#include "studio_run.h"

#include <algorithm>

namespace cambrian {
namespace {

using test::StudioRun;

ComparisonDraft small_comparison() {
    return {.varied = "population.size",
            .values = "6, 4",
            .random_search = true,
            .seeds = 2,
            .trials = ComparisonDraft::kFewestTrials};
}

const ComparisonView& facts(const StudioRun& run) {
    return *run.studio.frame_context().comparison;
}

void compare(StudioRun& run, const ComparisonDraft& draft) {
    run.studio.remember_in(run.folder.path() / "kept");
    run.ask(EditComparison{draft});
    run.ask(BeginComparison{});
}

TEST_CASE("settings are compared in the background, with random search", "[studio][comparison]") {
    StudioRun run;
    compare(run, small_comparison());
    REQUIRE(facts(run).problem.empty());
    REQUIRE(facts(run).running);
    REQUIRE(run.frames_until([&] { return !facts(run).running; }));
    CHECK(facts(run).problem.empty());
    CHECK(facts(run).share == 1.0);
    const ComparisonResults& results = *facts(run).results;
    REQUIRE(results.arms.size() == 3);
    CHECK(results.arms[0].name == "population.size=6");
    CHECK(results.arms[2].name == "random-search");
    CHECK(results.finished() == 6);
    for (const ComparedArm& arm : results.arms) {
        REQUIRE(arm.result);
        CHECK(arm.result->contest.has_value() == (&arm != results.arms.data()));
        CHECK_FALSE(arm.band.trials.empty());
        CHECK(std::filesystem::exists(arm.champion));
    }
    CHECK(std::filesystem::exists(std::filesystem::path(facts(run).folder) / "report.md"));
    run.ask(LoadFile{results.arms[1].champion});
    CHECK(run.frames_until([&] { return !run.studio.frame_context().viewer.playback.empty(); }));
}

TEST_CASE("a comparison that was stopped goes on with the runs that are missing",
          "[studio][comparison]") {
    StudioRun run;
    ComparisonDraft draft = small_comparison();
    draft.seeds = ComparisonDraft::kMostSeeds;
    compare(run, draft);
    REQUIRE(run.frames_until(
        [&] { return facts(run).results != nullptr && facts(run).results->finished() > 0; }));
    run.ask(StopComparison{});
    REQUIRE(run.frames_until([&] { return !facts(run).running; }));
    CHECK(facts(run).problem.empty());
    const std::size_t kept = facts(run).results->finished();
    CHECK(kept < facts(run).results->planned_runs());
    const std::string folder = facts(run).folder;
    draft.seeds = 1;
    run.ask(EditComparison{draft});
    run.ask(BeginComparison{});
    CHECK(facts(run).folder == folder);
    REQUIRE(run.frames_until([&] { return !facts(run).running; }));
    CHECK(facts(run).results->finished() == 3);
    const auto table = read_file(std::filesystem::path(folder) / "runs.csv", 1'000'000);
    REQUIRE(table);
    CHECK(static_cast<std::size_t>(std::count(table->begin(), table->end(), '\n')) >= kept + 1);
}

TEST_CASE("what cannot be compared is said, and nothing begins", "[studio][comparison]") {
    StudioRun run;
    run.studio.remember_in(run.folder.path() / "kept");
    const auto problem = [&](const std::string& varied, const std::string& values) {
        ComparisonDraft draft = small_comparison();
        draft.varied = varied;
        draft.values = values;
        run.ask(EditComparison{draft});
        CHECK(facts(run).problem.empty());
        run.ask(BeginComparison{});
        CHECK_FALSE(facts(run).running);
        return facts(run).problem;
    };
    CHECK(problem("population.size", "6, many").find("many") != std::string::npos);
    CHECK(problem("population.size", "6, -1").find("-1") != std::string::npos);
    CHECK(problem("population.size", "6, 6").find("two are called") != std::string::npos);
    CHECK(problem("population.size", "").find("population") != std::string::npos);
    CHECK(problem("environment.gravity", "1, 2").find("environment") != std::string::npos);
}

TEST_CASE("without a folder nothing is compared", "[studio][comparison]") {
    StudioRun run;
    run.ask(BeginComparison{});
    CHECK(facts(run).problem.find("no folder") != std::string::npos);
}

TEST_CASE("closing the window stops a comparison at once", "[studio][comparison]") {
    StudioRun run;
    ComparisonDraft draft = small_comparison();
    draft.trials = ComparisonDraft::kMostTrials;
    compare(run, draft);
    REQUIRE(run.frames_until([&] { return facts(run).share > 0.0; }));
}

TEST_CASE("the values suggested for a setting are valid and begin with the present one",
          "[studio][comparison]") {
    ExperimentSettings settings;
    int varied = 0;
    for (const SettingField& field : setting_fields(test::kinds())) {
        if (!may_vary(field)) continue;
        ++varied;
        INFO(path_of(field));
        const std::string values = suggested_values(field, settings);
        REQUIRE_FALSE(values.empty());
        const std::string present = values.substr(0, values.find(','));
        const auto plan =
            plan_of({.varied = path_of(field), .values = present}, settings, test::kinds());
        REQUIRE(plan);
        CHECK(planned_runs(*plan, test::kinds()));
    }
    CHECK(varied > 50);
}

}  // namespace
}  // namespace cambrian
