#include "studio/help/guide_controller.h"

#include "core/files/file_io.h"
#include "studio_fixture.h"
#include "studio_run.h"
#include "support/temporary_directory.h"

namespace cambrian {
namespace {

using test::StudioRun;

TEST_CASE("the tour is offered until the user takes or declines it", "[studio][guide]") {
    StudioRun run;
    run.studio.guide().offer_tour();
    CHECK(run.studio.frame_context().guide.tour_step == 0);
    run.ask(TurnTour{1});
    CHECK(run.studio.frame_context().guide.tour_step == 1);
    run.ask(TurnTour{-1});
    CHECK(run.studio.frame_context().guide.tour_step == -1);
    CHECK(run.studio.view().tour_taken);
    run.studio.guide().offer_tour();
    CHECK(run.studio.frame_context().guide.tour_step == -1);
    run.ask(TurnTour{0});  // the Help menu offers the tour at any time
    CHECK(run.studio.frame_context().guide.tour_step == 0);
}

TEST_CASE("the tour goes on by itself when a deed is done", "[studio][guide]") {
    StudioRun run;
    const auto step = [&] { return run.studio.frame_context().guide.tour_step; };
    run.studio.show_founders();
    run.studio.guide().offer_tour();
    run.studio.update(0.0, 0.001);
    CHECK(step() == 0);
    run.ask(RunOneGeneration{});  // evolving is the first deed, a finished generation the second
    REQUIRE(run.frames_until([&] { return step() == 2; }));
    ExperimentSettings moon = run.studio.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.studio.update(1.0, 0.001);
    CHECK(step() == 3);
    ViewState view = run.studio.view();
    view.look = LookMode::kGlass;
    run.ask(ChangeView{view});
    run.studio.update(2.0, 0.001);
    CHECK(step() == 4);
    CHECK_FALSE(run.studio.view().tour_taken);
    run.ask(SaveCreatureFile{run.folder.path() / "kept.creature.json"});
    REQUIRE(run.frames_until([&] { return step() == -1; }));
    CHECK(run.studio.view().tour_taken);
}

TEST_CASE("help pages and samples are read from the assets", "[studio][guide]") {
    StudioRun run;
    run.studio.use_assets(std::string(CAMBRIAN_SOURCE_DIR) + "/assets");
    REQUIRE(
        run.frames_until([&] { return !run.studio.frame_context().guide.help->pages.empty(); }));
    run.ask(ShowHelp{"viewport"});
    CHECK(run.studio.frame_context().guide.help_shown);
    CHECK(run.studio.frame_context().guide.help->open == "viewport");
    run.ask(ToggleSamples{});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().files.samples->read; }));
    CHECK_FALSE(run.studio.frame_context().files.samples->samples.empty());
}

TEST_CASE("the pictures of a page are read when it is opened", "[studio][guide]") {
    StudioRun run;
    run.studio.use_assets(std::string(CAMBRIAN_SOURCE_DIR) + "/assets");
    const HelpIndex& help = *run.studio.frame_context().guide.help;
    REQUIRE(run.frames_until([&] { return !help.pages.empty(); }));
    const auto pictures = [&help](const std::string& name) {
        std::vector<std::shared_ptr<const Image>> found;
        for (const HelpPage& page : help.pages) {
            for (const MarkdownBlock& block : page.blocks) {
                if (page.name == name && block.kind == BlockKind::kPicture)
                    found.push_back(block.picture);
            }
        }
        return found;
    };
    CHECK(pictures("preserve") == std::vector<std::shared_ptr<const Image>>(2));
    run.ask(ShowHelp{"preserve"});
    REQUIRE(run.frames_until([&] { return pictures("preserve").back() != nullptr; }));
    CHECK(pictures("preserve").front()->width == 1280);
    CHECK(pictures("benchmarks").front() == nullptr);
}

TEST_CASE("pictures that cannot be read are left out", "[studio][guide]") {
    const TemporaryDirectory folder;
    REQUIRE(write_file(folder.path() / "text.png", "no picture"));
    const HelpPage page = help_page("p", "![a](text.png)\n![b](missing.png)\n![c](../p.md)\n");
    CHECK(read_pictures(folder.path(), page).empty());
}

}  // namespace
}  // namespace cambrian
