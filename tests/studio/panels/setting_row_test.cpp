#include "studio/panels/experiment/setting_row.h"

#include "studio/widgets/widgets.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/null_imgui.h"

#include <algorithm>

namespace cambrian {
namespace {

SettingField field_named(const std::string& table, const std::string& key) {
    for (const SettingField& field : setting_fields(test::kinds())) {
        if (field.table == table && field.key == key) return field;
    }
    FAIL("no such field");
    return {};
}

TEST_CASE("sliders stay inside the allowed range and hold the default and the present value",
          "[studio][setting_row]") {
    ExperimentSettings defaults;
    for (const SettingField& field : setting_fields(test::kinds())) {
        const SettingRef ref = field.at(defaults);
        const auto* const* number = std::get_if<double*>(&ref);
        if (number == nullptr) continue;
        const double present = field.high;
        const SliderRange range = slider_range(field, **number, present);
        INFO(field.table << "." << field.key);
        CHECK(range.low >= field.low);
        CHECK(range.low <= **number);
        CHECK(range.high >= std::max(**number, present));
        CHECK(range.low < range.high);
    }
}

TEST_CASE("pressing into a slider sets the value under the mouse", "[studio][setting_row]") {
    NullImGui gui;
    const SettingField field = field_named("environment", "gravity");
    ExperimentSettings settings;
    ExperimentSettings defaults;
    RowEvent last = RowEvent::kNone;
    bool edited = false;
    bool finished = false;
    gui.click("environment.gravity", [&] {
        last = setting_row(field, settings, defaults);
        edited |= last == RowEvent::kEdited;
        finished |= last == RowEvent::kFinished;
    });
    CHECK(edited);
    CHECK(finished);
    const SliderRange range = slider_range(field, 9.81, 9.81);
    CHECK(settings.world.environment.gravity ==
          Approx(0.5 * (range.low + range.high)).epsilon(0.05));
}

TEST_CASE("pressing a switch flips it, once", "[studio][setting_row]") {
    NullImGui gui;
    const SettingField field = field_named("environment", "ground");
    ExperimentSettings settings;
    ExperimentSettings defaults;
    int finished = 0;
    gui.click("environment.ground", [&] {
        if (setting_row(field, settings, defaults) == RowEvent::kFinished) ++finished;
    });
    CHECK_FALSE(settings.world.environment.has_ground);
    CHECK(finished == 1);
}

TEST_CASE("a control is wide enough for its text in a panel of usual width",
          "[studio][setting_row]") {
    NullImGui gui(320.0F, 200.0F);
    ExperimentSettings settings;
    ExperimentSettings defaults;
    const SettingField integrator = field_named("simulation", "integrator");
    const SettingField limit = field_named("simulation", "max-evaluations");
    float choice = 0.0F;
    float number = 0.0F;
    gui.frame([&] {
        setting_row(integrator, settings, defaults);
        setting_row(limit, settings, defaults);
        choice = choice_width("Bogacki-Shampine");
        number = ImGui::CalcTextSize("1000000 evaluations/s").x;
    });
    CHECK(gui.place("simulation.integrator").width >= choice);
    CHECK(gui.place("simulation.max-evaluations").width >= number);
}

TEST_CASE("the right button offers the default back", "[studio][setting_row]") {
    NullImGui gui;
    const SettingField field = field_named("environment", "friction");
    ExperimentSettings settings;
    settings.world.environment.friction = 0.05;
    ExperimentSettings defaults;
    const auto draw = [&] { setting_row(field, settings, defaults); };
    gui.click("environment.friction", draw, 1);
    gui.click("reset environment.friction", draw);
    CHECK(settings.world.environment.friction == defaults.world.environment.friction);
}

}  // namespace
}  // namespace cambrian
