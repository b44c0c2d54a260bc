#include "studio/panels/comparison/comparison_panel.h"

#include "panel_press.h"

namespace cambrian {
namespace {

ComparedRun run_of(const std::string& arm, std::uint64_t seed, double score) {
    ComparedRun run;
    run.world = "walking";
    run.arm = arm;
    run.seed = seed;
    run.trials = 1000;
    run.confirmed = score;
    run.curve = {{300, 0.5 * score}, {1000, score}};
    return run;
}

TEST_CASE("a comparison is begun and stopped by its button", "[studio][comparison]") {
    test::PanelRun<ComparisonPanel> run(860, 640);
    CHECK(test::was_asked<BeginComparison>(run.click("Compare")));
    run.studio.comparison().running = true;
    run.frame();
    CHECK(test::was_asked<StopComparison>(run.click("Stop")));
    CHECK(test::was_asked<ToggleComparison>(run.click("Close the comparison")));
}

TEST_CASE("a setting is chosen from the list, with values to begin with", "[studio][comparison]") {
    test::PanelRun<ComparisonPanel> run(860, 640);
    run.click("Vary");
    run.frame();
    for (const char letter : std::string("selection method"))
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
    run.gui.forget_places();
    run.frame();
    run.frame();
    CHECK_FALSE(run.gui.has("vary population.size"));
    const auto draft = test::asked<EditComparison>(run.click("vary selection.method")).draft;
    CHECK(draft.varied == "selection.method");
    CHECK(draft.values.find(", ") != std::string::npos);
}

TEST_CASE("random search is switched off", "[studio][comparison]") {
    test::PanelRun<ComparisonPanel> run(860, 640);
    CHECK_FALSE(test::asked<EditComparison>(run.click("random search")).draft.random_search);
}

TEST_CASE("every arm has a row, and its best champion is shown", "[studio][comparison]") {
    test::PanelRun<ComparisonPanel> run(860, 640);
    const std::vector<ComparedRun> runs = {run_of("a", 1, 1.0), run_of("a", 2, 2.0),
                                           run_of("b", 1, 3.0)};
    run.studio.comparison().results =
        std::make_shared<const ComparisonResults>(results_of({"a", "b", "c"}, 2, runs, "folder"));
    run.frame();
    run.frame();
    for (const char* arm : {"arm a", "arm b", "arm c"})
        CHECK(run.gui.has(arm));
    CHECK(run.click("Show best").all().empty());  // the last arm has no run yet
    run.studio.comparison().results =
        std::make_shared<const ComparisonResults>(results_of({"a", "b"}, 2, runs, "folder"));
    run.frame();
    CHECK(test::asked<LoadFile>(run.click("Show best")).path ==
          "folder/champions/walking-b-seed1-1000-.creature.json");
}

TEST_CASE("results sum up the runs of each arm against the first", "[studio][comparison]") {
    const std::vector<ComparedRun> runs = {run_of("a", 1, 1.0), run_of("a", 2, 3.0),
                                           run_of("b", 1, 4.0)};
    const ComparisonResults results = results_of({"a", "b", "c"}, 2, runs, "folder");
    CHECK(results.finished() == 3);
    CHECK(results.planned_runs() == 6);
    CHECK(results.arms[0].result->median == 2.0);
    CHECK_FALSE(results.arms[0].result->contest);
    CHECK(results.arms[1].result->contest->ratio == 2.0);
    CHECK(results.arms[1].champion == "folder/champions/walking-b-seed1-1000-.creature.json");
    CHECK_FALSE(results.arms[2].result);
}

}  // namespace
}  // namespace cambrian
