#include "studio/host/changed_areas.h"

#include "support/null_imgui.h"

#include <string>

namespace cambrian {
namespace {

struct Box {
    std::string name;
    Rect place;
    ImU32 color = IM_COL32_WHITE;
    bool calls_back = false;
};

void no_painting(const ImDrawList*, const ImDrawCmd*) {}

// Windows with one filled box each, painted frame after frame on 640 by 480 pixels.
class Screen {
public:
    std::vector<Rect> paint(const std::vector<Box>& boxes, ImU32 background = IM_COL32_BLACK) {
        for (int layout = 0; layout < 2; ++layout)  // a new window is hidden in its first frame
            gui_.bare_frame([&boxes] {
                for (const Box& box : boxes)
                    draw(box);
            });
        return changed_.update(*ImGui::GetDrawData(), background);
    }

private:
    static void draw(const Box& box) {
        ImGui::SetNextWindowPos(box.place.low());
        ImGui::SetNextWindowSize({box.place.width, box.place.height});
        // Prevents clipping inside the window.
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        ImGui::Begin(box.name.c_str(), nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                         ImGuiWindowFlags_NoBringToFrontOnFocus);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (box.calls_back) list.AddCallback(no_painting, nullptr);
        list.AddRectFilled(box.place.low(), box.place.high(), box.color);
        ImGui::End();
        ImGui::PopStyleVar();
    }

    NullImGui gui_{640, 480};
    ChangedAreas changed_;
};

const std::vector<Rect> kNothing;
const std::vector<Rect> kAll = {{0, 0, 640, 480}};
const Box kLeft{"left", {10, 20, 100, 200}};
const Box kRight{"right", {300, 20, 200, 300}};

bool covers(const Rect& outer, const Rect& inner) {
    return outer.x <= inner.x && outer.y <= inner.y && outer.high().x >= inner.high().x &&
           outer.high().y >= inner.high().y;
}

TEST_CASE("the first frame is painted completely, an equal frame not at all",
          "[studio][changed_areas]") {
    Screen screen;
    CHECK(screen.paint({kLeft, kRight}) == kAll);
    CHECK(screen.paint({kLeft, kRight}) == kNothing);
}

TEST_CASE("only the window that changed is painted", "[studio][changed_areas]") {
    Screen screen;
    screen.paint({kLeft, kRight});
    Box right = kRight;
    right.color = IM_COL32(1, 2, 3, 255);
    const auto areas = screen.paint({kLeft, right});
    REQUIRE(areas.size() == 1);
    CHECK(areas.front() == kRight.place);
    CHECK(screen.paint({kLeft, right}) == kNothing);
}

TEST_CASE("a moved window is painted at its old and new places", "[studio][changed_areas]") {
    Screen screen;
    screen.paint({kLeft, kRight});
    Box left = kLeft;
    left.place.y = 250;
    const auto apart = screen.paint({left, kRight});
    REQUIRE(apart.size() == 2);
    CHECK(apart[0] == kLeft.place);
    CHECK(apart[1] == left.place);
    Box near = left;
    near.place.x += 7;
    const auto together = screen.paint({near, kRight});
    REQUIRE(together.size() == 1);
    CHECK(covers(together.front(), left.place));
    CHECK(covers(together.front(), near.place));
    CHECK(together.front().width == 107.0F);
}

TEST_CASE("windows that appear and disappear are painted", "[studio][changed_areas]") {
    Screen screen;
    screen.paint({kLeft});
    CHECK(screen.paint({kLeft, kRight}) == std::vector<Rect>{kRight.place});
    CHECK(screen.paint({kLeft}) == std::vector<Rect>{kRight.place});
}

TEST_CASE("a window with a callback is always painted, and completely", "[studio][changed_areas]") {
    Screen screen;
    Box scene = kRight;
    scene.calls_back = true;
    screen.paint({kLeft, scene});
    CHECK(screen.paint({kLeft, scene}) == std::vector<Rect>{scene.place});
    const Box over{"over", {290, 10, 50, 50}};
    const auto areas = screen.paint({kLeft, scene, over});
    REQUIRE(areas.size() == 1);
    CHECK(covers(areas.front(), scene.place));
    CHECK(covers(areas.front(), over.place));
}

TEST_CASE("a new background colour paints the full window", "[studio][changed_areas]") {
    Screen screen;
    screen.paint({kLeft, kRight});
    CHECK(screen.paint({kLeft, kRight}, IM_COL32_WHITE) == kAll);
    ImGui::GetIO().DisplaySize = {800, 600};
    CHECK(screen.paint({kLeft, kRight}, IM_COL32_WHITE) == std::vector<Rect>{{0, 0, 800, 600}});
}

}  // namespace
}  // namespace cambrian
