#include "persist/creature/champion_museum.h"
#include "studio/experiment/museum_keeper.h"
#include "studio/panels/cards/samples_panel.h"
#include "studio_fixture.h"
#include "studio_run.h"
#include "support/null_imgui.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <iterator>

namespace cambrian {
namespace {

using test::StudioRun;

std::ptrdiff_t exhibits_in(const std::filesystem::path& museum) {
    std::error_code none;
    return std::distance(std::filesystem::directory_iterator(museum, none), {});
}

void evolve_until(StudioRun& run, std::size_t champions) {
    run.ask(ToggleEvolution{});
    REQUIRE(run.frames_until([&] { return run.champions() >= champions; }));
    run.ask(ToggleEvolution{});
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.status == EngineStatus::kPaused;
    }));
}

TEST_CASE("the champion of a run goes into the museum and founds another run", "[studio][museum]") {
    const TemporaryDirectory folder;
    const std::filesystem::path museum = folder / "museum";
    StudioRun run;
    run.studio.remember_in(folder.path());
    evolve_until(run, kMuseumGenerations);
    run.ask(StartNewRun{});
    REQUIRE(run.frames_until(
        [&] { return run.log().find("{\"event\":\"museum\"") != std::string::npos; }));
    CHECK(exhibits_in(museum) == 1);
    ExperimentSettings draft = run.studio.frame_context().experiment.editor.draft();
    draft.population.museum = 0.2;
    run.ask(EditSettings{draft, "population.museum"});
    run.ask(StartNewRun{});
    run.ask(RunOneGeneration{});
    const auto founded = [&] {
        const auto& population = run.studio.frame_context().experiment.snapshot.population;
        return std::any_of(population.begin(), population.end(),
                           [](const IndividualPtr& one) { return one->method == "imported"; });
    };
    CHECK(run.frames_until(founded));
    // Founders that the user chooses take the museum's place.
    run.ask(StartFromShown{});
    CHECK(run.studio.frame_context().experiment.editor.draft().population.museum == 0.0);
}

TEST_CASE("a short run leaves the museum alone, and a window that closes does not",
          "[studio][museum]") {
    const TemporaryDirectory folder;
    StudioRun run;
    run.studio.remember_in(folder.path());
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    run.studio.close();
    CHECK(exhibits_in(folder / "museum") == 0);
    evolve_until(run, kMuseumGenerations);
    run.studio.close();
    CHECK(exhibits_in(folder / "museum") == 1);
}

TEST_CASE("the museum is shown below the samples", "[studio][museum]") {
    const TemporaryDirectory folder;
    CreatureDocument document{unjudged(test::crawler(test::kinds().creature.catalog))};
    REQUIRE(save_creature(folder / "walking-0.creature.json", document, test::kinds()));
    SampleLibrary library;
    library.samples = read_sample_folders({std::string(CAMBRIAN_SOURCE_DIR) + "/assets/creatures"},
                                          folder.path(), test::kinds(), nullptr);
    REQUIRE(library.samples.size() > 10);
    CHECK(library.samples.back().of_museum);
    CHECK_FALSE(library.samples.front().of_museum);
    const test::StudioFixture studio;
    FrameContext frame = studio.frame();
    frame.files.samples = &library;
    const auto names_museum = [&] {
        NullImGui gui;
        SamplesPanel panel;
        Requests out;
        gui.frame([&] { panel.draw(frame, out); });
        return gui.has("museum");
    };
    CHECK(names_museum());
    library.samples.pop_back();
    CHECK_FALSE(names_museum());
}

}  // namespace
}  // namespace cambrian
