#include "studio/probe/text_faults.h"

#include "support/null_imgui.h"

namespace cambrian {
namespace {

std::vector<TextFault> faults_of(const char* text, const ImVec2& at, const char* other = "") {
    NullImGui gui(200, 100);
    gui.frame([&] {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddText(at, paint(colors().text), text);
        list.AddText({20, 40}, paint(colors().text), other);
    });
    return find_text_faults();
}

TEST_CASE("text with room around it has no fault", "[studio][text_faults]") {
    CHECK(faults_of("Ground", {20, 20}, "Names").empty());
}

TEST_CASE("text over the edge of its window is cut", "[studio][text_faults]") {
    for (const ImVec2& at : {ImVec2(170, 20), ImVec2(-10, 20), ImVec2(20, 94)}) {
        const auto faults = faults_of("Ground", at);
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].kind == TextFaultKind::kCut);
    }
}

TEST_CASE("text drawn over other text is reported with it", "[studio][text_faults]") {
    const auto faults = faults_of("Ground", {24, 43}, "Names");
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].kind == TextFaultKind::kOverlap);
    CHECK(faults[0].text == "Ground");
    CHECK(faults[0].other == "Names");
}

TEST_CASE("a control partly outside its window is noted as cut, with the part that is seen",
          "[studio][text_faults]") {
    NullImGui gui(200, 100);
    gui.frame([] {
        note_place("inside", {10, 10, 50, 20});
        note_place("over the edge", {180, 10, 50, 20});
    });
    const auto& places = ui().places;
    CHECK_FALSE(places.at("inside").cut);
    CHECK(places.at("over the edge").cut);
    CHECK(places.at("over the edge").seen.width == 20.0F);
}

}  // namespace
}  // namespace cambrian
