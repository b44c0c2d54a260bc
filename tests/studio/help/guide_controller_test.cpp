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
