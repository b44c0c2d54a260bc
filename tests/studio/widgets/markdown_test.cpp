#include "studio/widgets/markdown.h"

#include "studio/widgets/markdown_view.h"
#include "support/catch.h"
#include "support/null_imgui.h"

#include <algorithm>
#include <memory>

namespace cambrian {
namespace {

TextSpan span(const char* text, SpanLook look = SpanLook::kPlain, const char* link = "") {
    return {text, look, link};
}
SpanLine plain(const char* text) {
    return {span(text)};
}

TEST_CASE("a page is parsed into its blocks", "[studio][markdown]") {
    const auto blocks = parse_markdown(
        "# Title\n\nTwo lines\nof one paragraph.\n\n- first\n  goes on\n- second\n\n"
        "| a | b |\n|---|---|\n| 1 | 2 |\n\n    code  one\n    code two\n\n![picture](x.png)\n");
    REQUIRE(blocks.size() == 7);
    CHECK(blocks[0].kind == BlockKind::kHeading);
    CHECK(blocks[0].level == 1);
    CHECK(blocks[1].line == plain("Two lines of one paragraph."));
    CHECK(blocks[2].kind == BlockKind::kBullet);
    CHECK(blocks[2].line == plain("first goes on"));
    CHECK(blocks[3].line == plain("second"));
    REQUIRE(blocks[4].rows.size() == 2);
    CHECK(blocks[4].rows[0][1] == SpanLine{span("b", SpanLook::kBold)});
    CHECK(blocks[4].rows[1][1] == plain("2"));
    CHECK(blocks[5].code == "code  one\ncode two");
    CHECK(blocks[6].kind == BlockKind::kPicture);
    CHECK(blocks[6].line == plain("picture"));
    CHECK(blocks[6].target == "x.png");
}

TEST_CASE("bold, code and links are recognised within a line", "[studio][markdown]") {
    const SpanLine told = {
        span("a "), span("b", SpanLook::kBold),          span(" "), span("c*", SpanLook::kCode),
        span(" "),  span("d", SpanLook::kPlain, "e.md"), span(" "), span("f", SpanLook::kBold)};
    CHECK(parse_spans("a **b** `c*` [d](e.md) *f*") == told);
}

TEST_CASE("marks that never close are plain text", "[studio][markdown]") {
    CHECK(parse_spans("2 * 3 [x] `open") == plain("2 * 3 [x] `open"));
    CHECK(parse_spans("**") == plain("**"));
    CHECK(parse_markdown("```\nnever closed").back().code == "never closed");
    CHECK(parse_markdown("|").empty());
    CHECK(parse_markdown("").empty());
}

TEST_CASE("what only looks like a picture is text", "[studio][markdown]") {
    for (const char* text : {"![", "![a", "![a]", "![a](b", "![a](b) c"}) {
        INFO(text);
        const auto blocks = parse_markdown(text);
        REQUIRE(blocks.size() == 1);
        CHECK(blocks[0].kind == BlockKind::kParagraph);
    }
}

TEST_CASE("a picture is no wider than its page, and a missing one is told in words",
          "[studio][markdown]") {
    NullImGui gui;
    auto blocks = parse_markdown("![a curve](x.png)\n");
    std::shared_ptr<const Image> asked;
    ui().texture_of = [&](const std::shared_ptr<const Image>& picture) {
        asked = picture;
        return ImTextureID();
    };
    float height = 0.0F;
    const auto draw = [&] {
        const float top = ImGui::GetCursorPosY();
        draw_markdown(blocks);
        height = ImGui::GetItemRectSize().y;
        CHECK(ImGui::GetCursorPosY() > top);
    };
    gui.frame(draw);
    CHECK(asked == nullptr);
    for (const int width : {100, 5000}) {
        blocks[0].picture = std::make_shared<const Image>(Image{width, width / 2, {}});
        float page = 0.0F;
        gui.frame([&] {
            page = ImGui::GetContentRegionAvail().x;
            draw();
        });
        CHECK(asked == blocks[0].picture);
        CHECK(height == Approx(0.5F * std::min(page, static_cast<float>(width))).margin(1.0));
    }
}

TEST_CASE("every kind of block can be drawn, and a link can be pressed", "[studio][markdown]") {
    NullImGui gui;
    const auto blocks = parse_markdown("[all](there.md)\n\n# H\n\n- b\n\n|\n\n| a |\n\n    code\n");
    std::string pressed;
    ImVec2 at;
    const auto draw = [&] {
        at = ImGui::GetCursorScreenPos();
        const std::string link = draw_markdown(blocks);
        if (!link.empty()) pressed = link;
    };
    gui.frame(draw);
    gui.move_to({at.x + 4, at.y + 6});
    gui.frame(draw);
    gui.press();
    gui.frame(draw);
    CHECK(pressed == "there.md");
}

}  // namespace
}  // namespace cambrian
