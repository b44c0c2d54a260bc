#include "core/files/file_io.h"
#include "evolution/fields/setting_words.h"
#include "studio/actions/action.h"
#include "studio/help/help_index.h"
#include "studio/panels/cards/help_panel.h"
#include "studio/rect_checks.h"
#include "studio_fixture.h"
#include "support/null_imgui.h"
#include "support/temporary_directory.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

std::vector<HelpPage> all_pages() {
    return read_help(std::string(CAMBRIAN_SOURCE_DIR) + "/assets/help", keys_text(),
                     words_text(setting_fields(test::kinds())));
}
const HelpPage& page_named(const std::vector<HelpPage>& pages, const std::string& name) {
    const auto found = std::find_if(pages.begin(), pages.end(),
                                    [&](const HelpPage& each) { return each.name == name; });
    INFO(name);
    REQUIRE(found != pages.end());
    return *found;
}
bool says(const HelpPage& page, const std::string& words) {
    for (const MarkdownBlock& block : page.blocks) {
        for (const TextSpan& span : block.line) {
            if (span.text.find(words) != std::string::npos) return true;
        }
        for (const auto& row : block.rows) {
            for (const SpanLine& cell : row) {
                if (!cell.empty() && cell.front().text == words) return true;
            }
        }
    }
    return false;
}

TEST_CASE("the help index has the built-in pages and those of the folder", "[studio][help]") {
    const auto pages = all_pages();
    CHECK(pages.front().name == kFirstStepsPage);
    CHECK(pages.back().name == kAboutPage);
    CHECK(page_named(pages, "experiment").title == "Experiment");
    CHECK(page_named(pages, "viewport").title == "Viewport");
    CHECK(says(page_named(pages, kAboutPage), "Dear ImGui"));
    CHECK(read_help("/no/such/folder", keys_text(), "# Words\n").size() == 4);
}

TEST_CASE("links to files that are no pages are told by name", "[studio][help]") {
    const TemporaryDirectory folder;
    REQUIRE(write_file(folder.path() / "a.md",
                       "# A\n\n[runs](runs.csv), [no page](part.md), [itself](a.md#b).\n"));
    REQUIRE(write_file(folder.path() / "part.md", "## No title\n"));
    const auto pages = read_help(folder.path(), keys_text(), "# Words\n");
    const SpanLine& line = page_named(pages, "a").blocks.at(1).line;
    REQUIRE(line.size() == 6);
    CHECK(line[0] == TextSpan{"runs (runs.csv)", SpanLook::kPlain, ""});
    CHECK(line[2].text == "no page (part.md)");
    CHECK(line[4] == TextSpan{"itself", SpanLook::kPlain, "a.md#b"});
}

TEST_CASE("every key is on the page of keys", "[studio][help]") {
    const auto pages = all_pages();
    for (const ActionTable& table : action_tables()) {
        for (const Action& action : table.actions) {
            if (action.keys.empty() || action.label.empty()) continue;
            const std::string stop = action.label.ends_with("…") ? " " : ". ";
            const std::string more = action.help.empty() ? "" : stop + action.help;
            CHECK(says(page_named(pages, kKeysPage), action.label + more));
        }
    }
}

TEST_CASE("a page is chosen from the list, and every page can be drawn", "[studio][help]") {
    NullImGui gui(1280.0F, 1000.0F);  // room for the names of all pages
    HelpPanel panel;
    test::StudioFixture studio;
    HelpIndex index{all_pages(), kFirstStepsPage};
    const std::size_t count = index.pages.size();
    for (std::size_t i = 0; i < count; ++i) {
        index.open = index.pages[i].name;
        FrameContext frame = studio.frame();
        frame.guide.help = &index;
        Requests out;
        const std::string next = index.pages[(i + 1) % count].name;
        gui.click("help " + next, [&] { panel.draw(frame, out); });
        CHECK(test::asked<ShowHelp>(out).page == next);
    }
    std::string text = "# Long\n";
    for (int i = 1; i < 100; ++i)
        text += fmt::format("\nParagraph {}.\n", i);
    HelpIndex longer{{help_page("long", text)}, "long"};
    FrameContext at_place = studio.frame();
    at_place.guide = {.help = &longer, .help_block = 80, .help_asked = 1};
    Requests none;
    for (int i = 0; i < 3; ++i)
        gui.frame([&] { panel.draw(at_place, none); });
    const Rect& marked = gui.place("## marked block");
    CHECK(test::inside(marked, 1280, 1000));
    index.open = "missing";
    FrameContext frame = studio.frame();
    frame.guide.help = &index;
    Requests out;
    gui.frame([&] { panel.draw(frame, out); });
}

}  // namespace
}  // namespace cambrian
