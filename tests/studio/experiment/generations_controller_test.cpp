#include "studio/experiment/generations_controller.h"

#include "studio_fixture.h"
#include "studio_run.h"

namespace cambrian {
namespace {

using test::finish_generations;
using test::shown_in;
using test::StudioRun;

TEST_CASE("one generation is evaluated, logged and its champion is displayed",
          "[studio][generations]") {
    StudioRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const FrameContext frame = run.studio.frame_context();
    REQUIRE_FALSE(frame.viewer.playback.empty());
    CHECK(frame.viewer.playback.exhibit().genome() ==
          frame.experiment.snapshot.champions[0].individual->genome);
    CHECK(run.log().find("{\"event\":\"generation\",\"number\":0,\"best\":") != std::string::npos);
}

TEST_CASE("scrubbing shows past champions until the newest is requested", "[studio][generations]") {
    StudioRun run;
    run.ask(ShowChampion{0});  // there is no champion yet, so it has no effect
    CHECK(run.studio.frame_context().viewer.playback.empty());
    finish_generations(run, 4);
    for (const std::uint32_t generation : {2U, 1U, 0U, 3U, 0U}) {
        run.ask(ShowChampion{generation});
        CHECK(shown_in(run).creature.generation == generation);
        CHECK(shown_in(run).genome() == run.studio.frame_context()
                                            .experiment.snapshot.champions[generation]
                                            .individual->genome);
    }
    run.ask(ShowChampion{77});
    CHECK(shown_in(run).creature.generation == 0);
    finish_generations(run, 5);
    run.ask(ShowChampion{1});
    run.ask(ShowNewest{});
    CHECK(shown_in(run).creature.generation == 4);
    CHECK(run.studio.view().newest_champion);
}

TEST_CASE("a champion whose genes were edited can be displayed as it was bred",
          "[studio][generations]") {
    StudioRun run;
    finish_generations(run, 2);
    run.ask(ShowChampion{0});
    const GenomePtr bred = shown_in(run).genome();
    Genome genome = *bred;
    genome.nodes[0].length = 1.5;
    run.ask(EditGenes{std::make_shared<const Genome>(genome), {"part 0 length", "old", "new"}});
    REQUIRE(shown_in(run).genome() != bred);
    run.ask(ShowChampion{0});
    CHECK(shown_in(run).genome() == bred);
}

TEST_CASE("after fast scrubbing the creature displayed last gets its score",
          "[studio][generations]") {
    StudioRun run;
    finish_generations(run, 3);
    for (int i = 0; i < 200; ++i)
        run.ask(ShowChampion{static_cast<std::uint32_t>(i % 3)});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().viewer.score != nullptr; }));
    CHECK(run.studio.frame_context().viewer.score->record.digest == shown_in(run).result()->digest);
}

TEST_CASE("a displayed creature can be starred and displayed again with its own settings",
          "[studio][generations]") {
    StudioRun run;
    run.studio.show_founders();
    run.ask(ToggleStarOfShown{});  // a creature of another experiment
    CHECK(run.studio.frame_context().generations.stars.all().empty());
    finish_generations(run, 1);
    run.ask(ShowNewest{});
    run.ask(ToggleStarOfShown{});
    REQUIRE(run.studio.frame_context().generations.stars.all().size() == 1);
    const JudgedIndividual kept = run.studio.frame_context().generations.stars.all().front();
    ExperimentSettings moon = run.studio.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(FinishEdit{});
    finish_generations(run, 3);
    run.ask(ShowIndividual{kept});
    CHECK(shown_in(run).genome() == kept.individual->genome);
    CHECK(shown_in(run).creature.generation == 0);
    CHECK(shown_in(run).settings().world.environment.gravity == 9.81);
    run.ask(ToggleStarOfShown{});
    CHECK(run.studio.frame_context().generations.stars.all().empty());
    run.ask(RestoreStar{});
    CHECK(run.studio.frame_context().generations.stars.all().size() == 1);
}

TEST_CASE("a new run begins without the stars of the run before", "[studio][generations]") {
    StudioRun run;
    finish_generations(run, 1);
    run.ask(ShowNewest{});
    run.ask(ToggleStarOfShown{});
    REQUIRE(run.studio.frame_context().generations.stars.all().size() == 1);
    run.ask(StartNewRun{});
    run.studio.update(0.0, 0.001);
    CHECK(run.studio.frame_context().generations.stars.all().empty());
    CHECK_FALSE(run.studio.frame_context().generations.stars.can_restore());
}

TEST_CASE("the score shown is the one the engine found, and the replay is verified",
          "[studio][generations]") {
    StudioRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().viewer.score != nullptr; }));
    const FrameContext frame = run.studio.frame_context();
    const EvaluationResult& result = *frame.viewer.playback.exhibit().result();
    CHECK(frame.viewer.score->score.value == unconfirmed_score(result));
    CHECK(frame.viewer.score->record.digest == result.digest);
}

TEST_CASE("a displayed champion has its line of descent", "[studio][generations]") {
    StudioRun run;
    for (std::size_t i = 0; i < 4; ++i) {
        run.ask(RunOneGeneration{});
        REQUIRE(run.frames_until([&] { return run.champions() == i + 1; }));
    }
    run.ask(ShowChampion{3});
    const FrameContext frame = run.studio.frame_context();
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    CHECK(exhibit.experiment == frame.experiment.snapshot.experiment);
    CHECK(exhibit.individual().mother.get() ==
          frame.experiment.snapshot.champions[3].individual->mother.get());
}

TEST_CASE("a newer champion waits while the user is at work on the one displayed",
          "[studio][generations]") {
    StudioRun run;
    finish_generations(run, 1);
    const GenomePtr first = shown_in(run).genome();
    const auto wait = [&] {
        for (int i = 0; i < 20; ++i) {
            run.studio.update(1000.0 + i, 0.001);
            run.ask(HoldShown{});
        }
    };
    SECTION("with the pointer in its controls") {
        run.ask(HoldShown{});
        for (std::size_t count = 2; count <= 6; ++count) {
            finish_generations(run, count);
            run.ask(HoldShown{});
        }
        wait();
        CHECK(shown_in(run).genome() == first);
    }
    SECTION("after forcing a neuron") {
        if (run.studio.frame_context()
                .viewer.playback.creature()
                .phenotype()
                .network.neurons.empty())
            return;
        run.ask(ForceNeuron{0, 1.0});
        for (std::size_t count = 2; count <= 6; ++count)
            finish_generations(run, count);
        for (int i = 0; i < 20; ++i)
            run.studio.update(1000.0 + i, 0.001);
        CHECK(shown_in(run).genome() == first);
    }
}

}  // namespace
}  // namespace cambrian
