#include "studio/help/guide_controller.h"

#include "studio_fixture.h"
#include "studio_run.h"

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

}  // namespace
}  // namespace cambrian
