#include "panel_press.h"
#include "studio/panels/cards/suggestions_card.h"
#include "studio_run.h"
#include "support/null_imgui.h"

namespace cambrian {
namespace {

using test::StudioRun;

// Presses a suggestion; returns what is asked for.
Requests taken(const char* label, void (*prepare)(test::StudioFixture&) = nullptr) {
    NullImGui gui;
    SuggestionsCard card;
    test::StudioFixture studio;
    studio.finish_generation(1.0);
    studio.snapshot().history.back().generations_without_progress = 15;
    if (prepare != nullptr) prepare(studio);
    Requests out = test::click(gui, card, studio, label);
    CHECK_FALSE(test::asked<ShowSuggestions>(out).shown);
    return out;
}

TEST_CASE("each suggestion changes one thing", "[studio][suggestions]") {
    const ExperimentSettings before;
    const auto edited = [](const char* label) {
        const Requests out = taken(label);
        CHECK(test::was_asked<FinishEdit>(out));
        return test::asked<EditSettings>(out).settings;
    };
    CHECK(edited("Mutate more").mutation.rate == 2.0 * before.mutation.rate);
    CHECK(edited("Breed more").population.size == 2 * before.population.size);
    CHECK(edited("Many kinds").selection.method == "map-elites");
    CHECK(edited("To the Moon").world.environment.gravity == 1.62);
    CHECK(test::asked<AddImmigrants>(taken("Add immigrants")).share == 0.2);
    CHECK_FALSE(test::asked<StartNewRun>(taken("Another seed")).keep_population);
    CHECK(test::was_asked<ToggleHandPicking>(taken("Pick by hand")));
    CHECK(test::asked<EditSettings>(taken("To the Earth", [](test::StudioFixture& studio) {
              ExperimentSettings moon = studio.editor().draft();
              moon.world.environment.gravity = 1.62;
              studio.editor().edit(moon, "environment.gravity");
          })).settings.world.environment.gravity == 9.81);
}

TEST_CASE("suggestions are made once in a run that is stuck, and again when asked for",
          "[studio][suggestions]") {
    StudioRun run;
    const auto shown = [&] { return run.studio.frame_context().coach.suggestions; };
    ExperimentSettings still = test::small_experiment();
    still.mutation.scheme = "none";  // every child is as its parents, so nothing gets better
    still.population.tuned = 0.0;
    still.breeding.shares = {{"asexual", 1.0}};
    run.ask(EditSettings{still, "mutation.scheme"});
    run.ask(FinishEdit{});
    run.ask(ToggleEvolution{});
    REQUIRE(run.frames_until([&] { return shown(); }));
    CHECK(run.champions() >= 15);
    run.ask(ShowSuggestions{false});
    const std::size_t then = run.champions();
    REQUIRE(run.frames_until([&] { return run.champions() > then + 2; }));
    CHECK_FALSE(shown());
    run.ask(ShowSuggestions{});
    CHECK(shown());
    run.ask(StartNewRun{});
    CHECK(run.frames_until([&] { return !shown(); }));
}

}  // namespace
}  // namespace cambrian
