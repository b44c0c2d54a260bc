#include "studio/viewer/viewer_controller.h"

#include "studio_fixture.h"
#include "studio_run.h"

#include <algorithm>

namespace cambrian {
namespace {

using test::StudioRun;

EditGenes lengthen_root(const FrameContext& frame, double length) {
    Genome genome = *frame.viewer.playback.exhibit().genome();
    genome.nodes[0].length = length;
    return {std::make_shared<const Genome>(genome), {"part 0 length", "old", "new"}};
}

double root_length(const StudioRun& run) {
    return run.studio.frame_context().viewer.playback.exhibit().genome()->nodes[0].length;
}

TEST_CASE("an edited gene is displayed at once, can be undone and made again", "[studio][viewer]") {
    StudioRun run;
    run.studio.show_founders();
    const double before = root_length(run);
    run.ask(lengthen_root(run.studio.frame_context(), 1.5));
    run.ask(FinishGeneEdit{});
    CHECK(run.studio.frame_context().viewer.playback.creature().phenotype().parts[0].length == 1.5);
    CHECK(run.studio.frame_context().viewer.playback.exhibit().individual().method == "edited");
    run.ask(UndoEdit{});
    CHECK(root_length(run) == before);
    CHECK(run.studio.frame_context().viewer.playback.exhibit().individual().method == "random");
    run.ask(RedoEdit{});
    CHECK(root_length(run) == 1.5);
    CHECK(run.log().find("{\"event\":\"gene edited\",\"place\":\"part 0 length\"") !=
          std::string::npos);
    CHECK(run.log().find("gene undone") != std::string::npos);
}

TEST_CASE("an edited creature is scored again and saved as edited", "[studio][viewer]") {
    StudioRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const std::uint64_t parent =
        run.studio.frame_context().viewer.playback.exhibit().individual().uid;
    run.ask(lengthen_root(run.studio.frame_context(), 1.1));
    run.ask(lengthen_root(run.studio.frame_context(), 1.2));
    CHECK(run.studio.frame_context().viewer.score == nullptr);
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().viewer.score != nullptr; }));
    const auto path = run.folder.path() / "edited.creature.json";
    run.ask(SaveCreatureFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    const auto saved = load_creature(path, test::kinds());
    REQUIRE(saved);
    CHECK(saved->creature.individual->method == "edited");
    CHECK(saved->creature.individual->parents == std::array<std::uint64_t, 2>{parent, 0});
    CHECK(saved->genome().nodes[0].length == 1.2);
}

TEST_CASE("the displayed creature's lesions are found, and it is pruned as an edit",
          "[studio][viewer]") {
    StudioRun run;
    run.studio.show_founders();
    const auto viewer = [&] { return run.studio.frame_context().viewer; };
    run.ask(StudyLesions{});
    CHECK(viewer().lesions->running());
    const GenomePtr whole = viewer().playback.exhibit().genome();
    REQUIRE(run.frames_until([&] { return viewer().lesions->table_of(whole) != nullptr; }));
    CHECK(!viewer().lesions->running());
    CHECK(!viewer().lesions->table_of(whole)->rows.empty());
    const LesionTable& table = *viewer().lesions->table_of(whole);
    const auto lost = std::find_if(table.rows.begin(), table.rows.end(), [](const LesionRow& row) {
        return row.lesions.front().kind == LesionKind::kLostPart;
    });
    REQUIRE(lost != table.rows.end());
    const std::size_t parts = viewer().playback.creature().phenotype().parts.size();
    run.ask(InflictLesions{lost->lesions});
    CHECK(viewer().playback.creature().phenotype().parts.size() < parts);
    CHECK(viewer().playback.creature().whole().parts.size() == parts);
    run.ask(RestartPlayback{});
    CHECK(viewer().playback.creature().phenotype().parts.size() < parts);
    run.ask(InflictLesions{});
    CHECK(viewer().playback.creature().phenotype().parts.size() == parts);
    run.ask(StudyLesions{.pairs = true});
    REQUIRE(run.frames_until([&] { return !viewer().lesions->running(); }));
    CHECK_FALSE(viewer().lesions->table_of(whole)->pairs.empty());
    run.ask(PruneShown{});
    CHECK(viewer().lesions->pruning());
    REQUIRE(run.frames_until([&] { return !viewer().lesions->running(); }));
    CHECK(run.log().find("{\"event\":\"pruned\"") != std::string::npos);
    run.ask(StudyLesions{});
    run.ask(StopLesions{});
    CHECK(!viewer().lesions->running());
}

TEST_CASE("a gene outside its range is refused with a message", "[studio][viewer]") {
    StudioRun run;
    run.studio.show_founders();
    const double before = root_length(run);
    run.ask(lengthen_root(run.studio.frame_context(), 25.0));
    run.studio.update(0.1, 0.0);
    CHECK(root_length(run) == before);
    REQUIRE(run.studio.frame_context().window.notice != nullptr);
    CHECK(run.studio.frame_context().window.notice->text.find("part 0 length") !=
          std::string::npos);
    CHECK_FALSE(run.studio.frame_context().can_undo());
}

TEST_CASE("with another creature on display, undo is of the settings again", "[studio][viewer]") {
    StudioRun run;
    run.studio.show_founders();
    const auto other =
        std::make_shared<const Exhibit>(run.studio.frame_context().viewer.playback.exhibit());
    run.ask(lengthen_root(run.studio.frame_context(), 1.5));
    ExperimentSettings moon = run.studio.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(ShowExhibit{other});
    run.ask(UndoEdit{});
    CHECK(run.studio.frame_context().experiment.editor.draft().world.environment.gravity == 9.81);
}

TEST_CASE("a forced neuron marks the run as disturbed", "[studio][viewer]") {
    StudioRun run;
    run.ask(ForceNeuron{0, 1.0});  // no creature is displayed, so it has no effect
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    REQUIRE_FALSE(
        run.studio.frame_context().viewer.playback.creature().phenotype().network.neurons.empty());
    run.ask(ForceNeuron{0, 1.0});
    CHECK(is_disturbed(run.studio.frame_context().viewer.playback.creature()));
    run.ask(ReleaseNeuron{0});
    CHECK(run.studio.frame_context().viewer.playback.creature().replay().forced().empty());
    run.ask(RestartPlayback{});
    CHECK_FALSE(is_disturbed(run.studio.frame_context().viewer.playback.creature()));
}

TEST_CASE("a highlight ends with the creature it belongs to", "[studio][viewer]") {
    StudioRun run;
    run.studio.show_founders();
    const auto other =
        std::make_shared<const Exhibit>(run.studio.frame_context().viewer.playback.exhibit());
    Requests requests;
    requests.ask(ShowHighlight{{.part = 5}});
    requests.ask(ShowExhibit{other});
    run.studio.carry_out(requests);
    CHECK(run.studio.frame_context().viewer.highlight == Highlight{});
    requests.ask(ShowHighlight{{.part = 5}});
    requests.ask(lengthen_root(run.studio.frame_context(), 1.5));
    run.studio.carry_out(requests);
    CHECK(run.studio.frame_context().viewer.highlight == Highlight{});
}

TEST_CASE("a part or neuron that the displayed creature lacks is left alone", "[studio][viewer]") {
    StudioRun run;
    run.ask(PokePart{});  // no creature is displayed, so it has no effect
    run.studio.show_founders();
    run.ask(PokePart{100'000});
    run.ask(ForceNeuron{100'000, 1.0});
    run.ask(ReleaseNeuron{100'000});
    CHECK(run.studio.frame_context().viewer.playback.creature().hold() == nullptr);
    CHECK(run.studio.frame_context().viewer.playback.creature().replay().forced().empty());
    run.studio.update(0.0, 0.1);
}

}  // namespace
}  // namespace cambrian
