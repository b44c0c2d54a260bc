#include "panel_press.h"
#include "studio/actions/action.h"
#include "studio/actions/palette_lines.h"
#include "studio/panels/cards/palette_panel.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace cambrian {
namespace {

std::vector<HelpPlace> some_help() {
    const HelpIndex index{{help_page("tides",
                                     "# Tides\n\nWater rises.\n\n## Ebb\n\nThe sea leaves "
                                     "walkers on dry sand.\n"),
                           help_page("empty", "")},
                          ""};
    return help_places(index);
}

std::vector<std::string> titles(const std::vector<PaletteLine>& lines) {
    std::vector<std::string> all;
    for (const PaletteLine& line : lines)
        all.push_back(line.title);
    return all;
}

TEST_CASE("words match in their order, best at the beginnings of a title's words",
          "[studio][palette]") {
    CHECK(match_rank("sav", "Save settings", "") == 0);
    CHECK(match_rank("SET", "Save settings", "") == 1);
    CHECK(match_rank("sa ings", "Save settings", "") == 2);
    CHECK(match_rank("toml", "Save settings", "As a TOML file") == 3);
    CHECK(match_rank("as file", "Save settings", "As a TOML file") == 4);
    CHECK(match_rank("oml", "Save settings", "As a TOML file") == 5);
    CHECK_FALSE(match_rank("settings save", "Save settings", "As a TOML file").has_value());
    CHECK_FALSE(match_rank("x", "", "").has_value());
    CHECK(match_rank("", "Save", "") == 0);
}

TEST_CASE("the palette finds actions, settings by either word, and the help's text",
          "[studio][palette]") {
    const test::StudioFixture studio;
    const FrameContext frame = studio.frame();
    const auto found = [&](const char* words) { return palette_lines(words, frame, some_help()); };
    CHECK(found("save settings").front().kind == "Ctrl+Shift+S");
    CHECK(found("bounc").front().title == "Bounciness (restitution)");
    CHECK(found("restit").front().title == "Bounciness (restitution)");
    CHECK(titles(found("grip")).front() == "Grip (friction)");
    const std::vector<PaletteLine> help = found("dry sand");
    REQUIRE(help.size() == 1);
    CHECK(help[0].title == "Ebb");
    CHECK(help[0].what == "Tides: The sea leaves walkers on dry sand.");
    Requests out;
    help[0].go(frame, out);
    CHECK(test::asked<ShowHelp>(out).page == "tides");
    CHECK(test::asked<ShowHelp>(out).block == 3);
    found("grip").front().go(frame, out);
    CHECK(test::asked<ShowSetting>(out).path == "environment.friction");
    CHECK(found("xylophone").empty());
    CHECK(titles(found("gravity")) == titles(found("gravity")));
}

TEST_CASE("without words the palette lists what can be done, each thing once",
          "[studio][palette]") {
    test::StudioFixture studio;
    const auto listed = [&] {
        std::vector<std::string> all = titles(palette_lines("", studio.frame(), some_help()));
        std::sort(all.begin(), all.end());
        CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
        CHECK(all.size() > 60);
        return all;
    };
    const auto has = [](const std::vector<std::string>& all, const char* title) {
        return std::find(all.begin(), all.end(), title) != all.end();
    };
    CHECK_FALSE(has(listed(), "Breed the next grid from the picks"));
    studio.show_grid(4);
    CHECK(has(listed(), "Breed the next grid from the picks"));
}

struct PaletteRun : test::PanelRun<PalettePanel> {
    PaletteRun() : test::PanelRun<PalettePanel>(680.0F, 460.0F) {
        constexpr int first = 300;
        int key = first;
        for (const ImGuiKey used :
             {ImGuiKey_Enter, ImGuiKey_DownArrow, ImGuiKey_UpArrow, ImGuiKey_Escape})
            ImGui::GetIO().KeyMap[used] = key++;
        frame();
        frame();
        frame();
    }
    void type(const char* text) {
        ImGui::GetIO().AddInputCharactersUTF8(text);
        frame();
        gui.forget_places();
        frame();
    }
    void press(ImGuiKey key) {
        bool& down = ImGui::GetIO().KeysDown[ImGui::GetIO().KeyMap[key]];
        down = true;
        frame();
        down = false;
        frame();
    }
};

TEST_CASE("typing and Enter do what the palette found, and close it", "[studio][palette]") {
    PaletteRun run;
    run.type("light theme");
    CHECK(run.gui.has("found Light theme"));
    CHECK_FALSE(run.gui.has("found Evolve or pause"));
    run.press(ImGuiKey_Enter);
    CHECK(test::was_asked<TogglePalette>(run.out));
    CHECK(test::asked<ChangeView>(run.out).view.theme == ThemeKind::kLight);
}

TEST_CASE("arrows choose another line of the palette", "[studio][palette]") {
    PaletteRun run;
    run.type("evolve");
    run.press(ImGuiKey_DownArrow);
    run.press(ImGuiKey_Enter);
    CHECK(test::was_asked<RunOneGeneration>(run.out));
    CHECK_FALSE(test::was_asked<ToggleEvolution>(run.out));
}

TEST_CASE("a line is clicked, but not one that cannot be done now", "[studio][palette]") {
    for (const bool has_generation : {false, true}) {
        PaletteRun run;
        if (has_generation) run.studio.finish_generation(1.0);
        run.type("export");
        const Requests asked = run.click("found Export statistics as CSV…");
        CHECK(asked.all().empty() != has_generation);
        CHECK(test::was_asked<OpenFilePanel>(asked) == has_generation);
    }
}

TEST_CASE("Ctrl+P opens the palette, Esc closes it, and other keys wait meanwhile",
          "[studio][palette]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    FrameContext frame = studio.frame();
    const auto requests_of = [&](const KeyPress& press, bool typing) {
        Requests out;
        press_shortcut(press, typing, frame, out);
        return out;
    };
    CHECK(test::was_asked<TogglePalette>(requests_of({GLFW_KEY_P, true}, true)));
    frame.window.palette_open = true;
    CHECK(requests_of({GLFW_KEY_ENTER}, false).all().empty());
    CHECK(test::was_asked<TogglePalette>(requests_of({GLFW_KEY_ESCAPE}, true)));
}

}  // namespace
}  // namespace cambrian
