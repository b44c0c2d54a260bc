#include "studio/help/guide_controller.h"

#include "session_run.h"
#include "studio_fixture.h"

namespace cambrian {
namespace {

using test::SessionRun;

TEST_CASE("the tour is offered until the user takes or declines it", "[studio][guide]") {
    SessionRun run;
    run.session.guide().offer_tour();
    CHECK(run.session.frame_context().guide.tour_step == 0);
    run.ask(TurnTour{1});
    CHECK(run.session.frame_context().guide.tour_step == 1);
    run.ask(TurnTour{-1});
    CHECK(run.session.frame_context().guide.tour_step == -1);
    CHECK(run.session.view().tour_taken);
    run.session.guide().offer_tour();
    CHECK(run.session.frame_context().guide.tour_step == -1);
    run.ask(TurnTour{0});  // the Help menu offers the tour at any time
    CHECK(run.session.frame_context().guide.tour_step == 0);
}

TEST_CASE("help pages and samples are read from the assets", "[studio][guide]") {
    SessionRun run;
    run.session.use_assets(std::string(CAMBRIAN_SOURCE_DIR) + "/assets");
    REQUIRE(
        run.frames_until([&] { return !run.session.frame_context().guide.help->pages.empty(); }));
    run.ask(ShowHelp{"viewport"});
    CHECK(run.session.frame_context().guide.help_shown);
    CHECK(run.session.frame_context().guide.help->open == "viewport");
    run.ask(ToggleSamples{});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().files.samples->read; }));
    CHECK_FALSE(run.session.frame_context().files.samples->samples.empty());
}

}  // namespace
}  // namespace cambrian
