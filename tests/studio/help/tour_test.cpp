#include "studio/help/tour.h"

#include "studio/main_window.h"
#include "studio/panels/builtin_panels.h"
#include "studio/panels/cards/tour_card.h"
#include "studio_fixture.h"
#include "support/null_imgui.h"

namespace cambrian {
namespace {

TEST_CASE("the tour is short, and its steps name controls that exist", "[studio][tour]") {
    NullImGui gui(1280.0F, 720.0F);
    MainWindow window(builtin_panels(), nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    CHECK(tour_steps().size() <= 5);
    Requests out;
    gui.frame([&] { window.draw(studio.frame(), out); });
    for (const TourStep& step : tour_steps()) {
        const Rect& subject = gui.place(step.place);
        const Rect card = tour_card_place(subject, {0, 0, 1280, 720});
        INFO(step.place);
        CHECK(card.x >= 0.0F);
        CHECK(card.y >= 0.0F);
        CHECK(card.x + card.width <= 1280.0F);
        CHECK(card.y + card.height <= 720.0F);
    }
}

TEST_CASE("the tour can be stepped through and skipped", "[studio][tour]") {
    NullImGui gui;
    TourCard card;
    test::StudioFixture studio;
    FrameContext frame = studio.frame();
    frame.guide.tour_step = 1;
    const auto click = [&](const char* name) {
        Requests out;
        gui.click(name, [&] { card.draw(frame, out); });
        return test::asked<TurnTour>(out).step;
    };
    CHECK(click("Next") == 2);
    CHECK(click("Skip") == static_cast<int>(tour_steps().size()));
    frame.guide.tour_step = static_cast<int>(tour_steps().size()) - 1;
    CHECK(click("Done") == static_cast<int>(tour_steps().size()));
}

}  // namespace
}  // namespace cambrian
