#include "studio/host/window.h"

#include "studio/host/imgui_host.h"
#include "support/catch.h"
#include "support/null_imgui.h"

#include <limits>

namespace cambrian {
namespace {

TEST_CASE("a scale that no display has is replaced by one that can be used", "[studio][window]") {
    CHECK(usable_scale(1.0F) == 1.0F);
    CHECK(usable_scale(1.75F) == 1.75F);
    CHECK(usable_scale(0.01F) == 0.5F);
    CHECK(usable_scale(52.0F) == 4.0F);
    CHECK(usable_scale(std::numeric_limits<float>::infinity()) == 4.0F);
    for (const float told : {0.0F, -2.0F, std::numeric_limits<float>::quiet_NaN()})
        CHECK(usable_scale(told) == 1.0F);
}

TEST_CASE("menus and pop-ups are closed one by one", "[studio][window]") {
    NullImGui gui;
    bool first = false;
    bool second = false;
    const auto draw = [&] {
        if (ImGui::GetFrameCount() == 1) ImGui::OpenPopup("first");
        first = ImGui::BeginPopup("first");
        if (!first) return;
        if (ImGui::GetFrameCount() == 1) ImGui::OpenPopup("second");
        second = ImGui::BeginPopup("second");
        if (second) ImGui::EndPopup();
        ImGui::EndPopup();
    };
    gui.frame(draw);
    gui.frame(draw);
    REQUIRE((first && second));
    CHECK(ImGuiHost::close_popup());
    second = false;
    gui.frame(draw);
    CHECK(first);
    CHECK_FALSE(second);
    CHECK(ImGuiHost::close_popup());
    gui.frame(draw);
    CHECK_FALSE(first);
    CHECK_FALSE(ImGuiHost::close_popup());
}

}  // namespace
}  // namespace cambrian
