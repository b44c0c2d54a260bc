#include "panel_press.h"
#include "studio/panels/opening/founders_panel.h"
#include "studio/panels/opening/founders_strip.h"
#include "support/null_imgui.h"

namespace cambrian {
namespace {

// Draws founders of a population of twelve, once all of them move.
class Crowd {
public:
    Crowd() {
        ExperimentSettings settings;
        settings.population.size = 12;
        settings.world.trial.duration = 0.5;
        crowd.show(std::make_shared<const ExperimentSettings>(settings));
        const auto known = [this] {
            crowd.advance(0.01);
            for (std::size_t i = 0; i < crowd.motion().size(); ++i)
                if (!crowd.motion().cell(i).complete) return false;
            return true;
        };
        while (!known())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FrameContext frame() {
        FrameContext frame = studio.frame();
        frame.coach = {.founders = &crowd, .founder = 0};
        return frame;
    }

    test::StudioFixture studio;
    FounderCrowd crowd{test::kinds()};
};

TEST_CASE("a click among the founders chooses the nearest", "[studio][founders]") {
    NullImGui gui;
    FoundersPanel panel(nullptr);
    Crowd crowd;
    const auto chosen_at = [&](float across, float down) {
        Requests out;
        const auto draw = [&] { panel.draw(crowd.frame(), out); };
        gui.frame(draw);
        const Rect& area = gui.place("founders");
        gui.move_to({area.x + across * area.width, area.y + down * area.height});
        gui.frame(draw);
        gui.press();
        gui.frame(draw);
        gui.release();
        gui.frame(draw);
        return test::asked<ChooseFounder>(out).place;
    };
    CHECK(chosen_at(0.05F, 0.75F) == 0);  // the front row from the left
    CHECK(chosen_at(0.95F, 0.75F) == 5);
    CHECK(chosen_at(0.05F, 0.2F) == 6);  // the row behind it
}

TEST_CASE("the strip below the founders offers others", "[studio][founders]") {
    NullImGui gui;
    FoundersStrip strip;
    Crowd crowd;
    Requests out;
    gui.click("Other creatures", [&] { strip.draw(crowd.frame(), out); });
    CHECK(test::was_asked<StartNewRun>(out));
}

}  // namespace
}  // namespace cambrian
