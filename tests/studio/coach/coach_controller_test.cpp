#include "studio/coach/coach_controller.h"

#include "evolution/evaluation/trials.h"
#include "studio/coach/rivals.h"
#include "studio_run.h"

#include <algorithm>
#include <set>

namespace cambrian {
namespace {

using test::StudioRun;

const FounderCrowd* crowd_in(const StudioRun& run) {
    return run.studio.frame_context().coach.founders;
}

std::set<std::uint64_t> uids_of(const std::vector<IndividualPtr>& creatures) {
    std::set<std::uint64_t> uids;
    for (const IndividualPtr& each : creatures)
        uids.insert(each->uid);
    return uids;
}

TEST_CASE("evolution begins with the creatures that are displayed before it", "[studio][coach]") {
    StudioRun run;
    run.studio.show_founders();
    REQUIRE(run.frames_until([&] { return crowd_in(run) != nullptr; }));
    const std::set<std::uint64_t> shown = uids_of(crowd_in(run)->founders());
    CHECK(shown.size() == 6);  // no more than the population
    test::finish_generations(run, 1);
    CHECK(uids_of(run.studio.frame_context().experiment.snapshot.population) == shown);
    CHECK(crowd_in(run) == nullptr);
    REQUIRE(
        run.frames_until([&] { return test::shown_in(run).source == ExhibitSource::kChampion; }));
    run.ask(StartNewRun{});
    REQUIRE(run.frames_until([&] { return crowd_in(run) != nullptr; }));
    CHECK(uids_of(crowd_in(run)->founders()) != shown);  // another seed
}

TEST_CASE("other settings make other founders, and the inspector follows", "[studio][coach]") {
    StudioRun run;
    run.studio.show_founders();
    REQUIRE(run.frames_until([&] { return crowd_in(run) != nullptr; }));
    run.ask(ChooseFounder{3});
    CHECK(run.studio.frame_context().coach.founder == 3);
    const std::set<std::uint64_t> before = uids_of(crowd_in(run)->founders());
    ExperimentSettings other = run.studio.frame_context().experiment.editor.draft();
    other.seed = 77;
    run.ask(EditSettings{other, "run.seed"});
    run.ask(FinishEdit{});
    REQUIRE(run.frames_until(
        [&] { return crowd_in(run) != nullptr && uids_of(crowd_in(run)->founders()) != before; }));
    CHECK(test::shown_in(run).settings().seed == 77);
    CHECK(uids_of(crowd_in(run)->founders()).count(test::shown_in(run).individual().uid) == 1);
}

TEST_CASE("founders give way to any other creature, and are not those of given ones",
          "[studio][coach]") {
    StudioRun run;
    run.studio.show_founders();
    REQUIRE(run.frames_until([&] { return crowd_in(run) != nullptr; }));
    run.ask(StartFromShown{});
    run.studio.update(0.0, 0.001);
    CHECK(crowd_in(run) == nullptr);
    run.ask(StartNewRun{});
    REQUIRE(run.frames_until([&] { return crowd_in(run) != nullptr; }));
    run.ask(ShowExhibit{std::make_shared<const Exhibit>(test::crawler_exhibit())});
    CHECK(crowd_in(run) == nullptr);
}

std::filesystem::path samples() {
    return std::string(CAMBRIAN_SOURCE_DIR) + "/assets/creatures";
}

TEST_CASE("rivals have the goal and the world of the run, and are judged as its creatures are",
          "[studio][coach]") {
    ExperimentSettings settings = test::small_experiment();
    settings.selection.confirmations = 0;
    const auto rivals = judge_rivals(samples(), settings, test::kinds(), {});
    REQUIRE(rivals.size() > 3);
    CHECK(std::is_sorted(
        rivals.begin(), rivals.end(),
        [](const JudgedRival& a, const JudgedRival& b) { return a.score < b.score; }));
    const JudgedRival& best = rivals.back();
    CHECK(best.creature.settings->world == settings.world);
    const EvaluationRequest request{.genome = best.creature.individual->genome,
                                    .trial_seed = trial_seed(settings)};
    CHECK(evaluate_in_trials(request, *best.creature.settings, test::kinds()).fitness ==
          best.score);

    settings.world.environment.gravity = 1.62;  // no sample was bred there
    CHECK(judge_rivals(samples(), settings, test::kinds(), {}).empty());
    CHECK(judge_rivals("/no/such/folder", settings, test::kinds(), {}).empty());
}

TEST_CASE("a rival runs beside the champion until it is beaten, which is told", "[studio][coach]") {
    StudioRun run;
    run.studio.use_assets(std::string(CAMBRIAN_SOURCE_DIR) + "/assets");
    test::finish_generations(run, 1);
    const auto beside = [&] { return run.studio.frame_context().viewer.ghosts; };
    REQUIRE(run.frames_until([&] { return beside().size() == 1; }));
    for (std::size_t count = 2; count < 60; ++count) {
        if (run.log().find("rival beaten") != std::string::npos) break;
        test::finish_generations(run, count);
    }
    CHECK(run.log().find(" is ahead of ") != std::string::npos);
    const std::string log = run.log();
    const std::size_t at = log.rfind("{\"event\":\"rival beaten\"");
    const std::string beaten = log.substr(log.find("\"name\":\"", at) + 8);
    const std::string name = beaten.substr(0, beaten.find('"'));
    CHECK(run.frames_until(
        [&] { return beside().size() == 1 && beside().front()->words().find(name + ",") != 0; }));

    ViewState alone = run.studio.view();
    alone.rival = false;
    run.ask(ChangeView{alone});
    CHECK(run.frames_until([&] { return beside().empty(); }));
}

}  // namespace
}  // namespace cambrian
