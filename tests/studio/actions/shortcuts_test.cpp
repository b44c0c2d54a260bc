#include "studio/actions/action.h"
#include "studio_fixture.h"

#include <GLFW/glfw3.h>

#include <set>

namespace cambrian {
namespace {

TEST_CASE("no two shortcuts share a key", "[studio][shortcuts]") {
    std::set<std::string> every_mode;
    for (const ActionTable& table : action_tables()) {
        std::set<std::string> of_mode;
        for (const Action& action : table.actions) {
            INFO(table.title << ": " << action.label << " " << action.keys);
            std::set<std::string>& taken = table.active == nullptr ? every_mode : of_mode;
            if (!action.keys.empty()) CHECK(taken.insert(action.keys).second);
        }
    }
}

TEST_CASE("Space evolves, but not while text is typed", "[studio][shortcuts]") {
    const test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_SPACE}, true, studio.frame(), out);
    CHECK(out.all().empty());
    press_shortcut({GLFW_KEY_SPACE}, false, studio.frame(), out);
    CHECK(test::was_asked<ToggleEvolution>(out));
}

TEST_CASE("while text is typed, Ctrl+Z and Esc are for the text", "[studio][shortcuts]") {
    test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_Z, true}, true, studio.frame(), out);
    press_shortcut({GLFW_KEY_Z, true, true}, true, studio.frame(), out);
    press_shortcut({GLFW_KEY_ESCAPE}, true, studio.frame(), out);
    CHECK(out.all().empty());
    studio.files().open = true;
    press_shortcut({GLFW_KEY_ESCAPE}, true, studio.frame(), out);
    CHECK(test::was_asked<CloseFilePanel>(out));
}

TEST_CASE("Shift distinguishes redo from undo", "[studio][shortcuts]") {
    const test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_Z, true, true}, false, studio.frame(), out);
    CHECK(test::was_asked<RedoEdit>(out));
    CHECK_FALSE(test::was_asked<UndoEdit>(out));
}

TEST_CASE("the speed keys step through the speeds and stop at the ends", "[studio][shortcuts]") {
    const test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_RIGHT_BRACKET}, false, studio.frame(), out);
    CHECK(test::asked<ChangeView>(out).view.speed == 2.0);
    Requests slower;
    press_shortcut({GLFW_KEY_LEFT_BRACKET}, false, studio.frame(), slower);
    CHECK(test::asked<ChangeView>(slower).view.speed == 0.5);
}

TEST_CASE("keys step through the sizes of the interface and stop at the ends",
          "[studio][shortcuts]") {
    test::StudioFixture studio;
    const auto size_after = [&](const KeyPress& press) {
        Requests out;
        press_shortcut(press, true, studio.frame(), out);
        return out.all().empty() ? studio.view().size : test::asked<ChangeView>(out).view.size;
    };
    CHECK(size_after({GLFW_KEY_EQUAL, true}) == 110);
    CHECK(size_after({GLFW_KEY_EQUAL, true, true}) == 110);
    CHECK(size_after({GLFW_KEY_KP_ADD, true}) == 110);
    CHECK(size_after({GLFW_KEY_KP_SUBTRACT, true}) == 90);
    studio.view().size = 200;
    CHECK(size_after({GLFW_KEY_EQUAL, true}) == 200);
    CHECK(size_after({GLFW_KEY_0, true}) == 100);
    studio.view().size = 80;
    CHECK(size_after({GLFW_KEY_MINUS, true}) == 80);
}

TEST_CASE("where one side panel hides the other, its menu line shows it instead",
          "[studio][shortcuts]") {
    test::StudioFixture studio;
    FrameContext frame = studio.frame();
    frame.window.narrow = true;
    const Action& right = *find_action("panel-right", frame).action;
    CHECK_FALSE(right.chosen(frame));
    Requests out;
    right.ask(frame, out);
    CHECK(test::asked<ChangeView>(out).view.panels.right);
    CHECK_FALSE(test::asked<ChangeView>(out).view.panels.left);
    frame.window.narrow = false;
    CHECK(right.chosen(frame));
}

TEST_CASE("over the grid Space picks the creature in focus", "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    studio.focus_cell(4);
    Requests out;
    press_shortcut({GLFW_KEY_SPACE}, false, studio.frame(), out);
    CHECK(test::asked_picking<TogglePick>(out).cell == 4);
    CHECK_FALSE(test::was_asked<ToggleEvolution>(out));
}

TEST_CASE("number keys pick cells that exist", "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    Requests out;
    press_shortcut({GLFW_KEY_9}, false, studio.frame(), out);
    CHECK(test::asked_picking<TogglePick>(out).cell == 8);
    CHECK(test::asked<FocusCell>(out).cell == 8);
    Requests beyond;
    press_shortcut({GLFW_KEY_EQUAL}, false, studio.frame(), beyond);
    CHECK(beyond.all().empty());
}

TEST_CASE("arrows move the focus and stop at the edges of the grid",
          "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(12);  // 4 by 3
    const auto after = [&](std::size_t from, int key) {
        studio.focus_cell(from);
        Requests out;
        press_shortcut({key}, false, studio.frame(), out);
        return out.all().empty() ? from : test::asked<FocusCell>(out).cell;
    };
    CHECK(after(0, GLFW_KEY_RIGHT) == 1);
    CHECK(after(3, GLFW_KEY_RIGHT) == 3);
    CHECK(after(4, GLFW_KEY_LEFT) == 4);
    CHECK(after(1, GLFW_KEY_DOWN) == 5);
    CHECK(after(9, GLFW_KEY_DOWN) == 9);
    CHECK(after(2, GLFW_KEY_UP) == 2);
}

TEST_CASE("Escape leads from one creature back to the grid", "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    studio.show_single();
    Requests out;
    press_shortcut({GLFW_KEY_ESCAPE}, false, studio.frame(), out);
    CHECK(test::was_asked<ShowGrid>(out));
}

TEST_CASE("keys for a card do not reach the grid behind it", "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    SampleLibrary samples;
    samples.open = true;
    FrameContext frame = studio.frame();
    frame.files.samples = &samples;
    const auto requests_of = [&](int key) {
        Requests out;
        press_shortcut({key}, false, frame, out);
        return out;
    };
    CHECK(requests_of(GLFW_KEY_RIGHT).all().empty());
    CHECK(requests_of(GLFW_KEY_ENTER).all().empty());
    samples.open = false;
    CHECK(test::was_asked<FocusCell>(requests_of(GLFW_KEY_RIGHT)));
    frame.guide.tour_step = 0;
    CHECK(requests_of(GLFW_KEY_RIGHT).all().empty());
}

ResidentPicture resident(std::uint64_t number, std::uint64_t lineage, std::uint64_t parent = 0) {
    ResidentPicture picture;
    picture.life.number = number;
    picture.life.lineage = lineage;
    picture.life.parents[0] = parent;
    return picture;
}

// Returns the creature that a key picks; 0 if it picks none.
std::uint64_t picked_by(const KeyPress& press, const PreservePicture& picture,
                        std::uint64_t picked) {
    const test::StudioFixture studio;
    const std::filesystem::path file = "pond.cambrian";
    const Pins pins;
    const PreserveView view{
        .picture = picture, .file = file, .picked = picture.find(picked), .pins = pins};
    FrameContext frame = studio.frame();
    frame.preserve = &view;
    Requests out;
    press_shortcut(press, false, frame, out);
    return test::was_asked<PickResident>(out) ? test::asked<PickResident>(out).number : 0;
}

TEST_CASE("keys pick lineages, outstanding creatures and kin", "[studio][shortcuts][preserve]") {
    PreservePicture picture;
    picture.residents = {resident(2, 2), resident(3, 3), resident(5, 3, 3), resident(7, 7, 5)};
    picture.residents[1].life.mass = 2.0;
    picture.residents[2].life.children = 1;
    const auto by = [&](int key, std::uint64_t picked, bool shift = false) {
        return picked_by({key, false, shift}, picture, picked);
    };
    // The largest lineage is that of 3, then come those of 2 and of 7.
    CHECK(by(GLFW_KEY_L, 0) == 3);
    CHECK(by(GLFW_KEY_L, 5) == 2);
    CHECK(by(GLFW_KEY_L, 7) == 3);
    CHECK(by(GLFW_KEY_L, 3, true) == 7);
    CHECK(by(GLFW_KEY_O, 0) == 5);
    CHECK(by(GLFW_KEY_O, 5) == 3);
    CHECK(by(GLFW_KEY_O, 3) == 5);
    CHECK(by(GLFW_KEY_U, 7) == 5);
    CHECK(by(GLFW_KEY_U, 7, true) == 5);
    CHECK(by(GLFW_KEY_U, 2) == 0);
    CHECK(by(GLFW_KEY_C, 3) == 5);
    CHECK(by(GLFW_KEY_C, 7) == 0);
    CHECK(by(GLFW_KEY_C, 3, true) == 0);
    CHECK(by(GLFW_KEY_C, 7, true) == 7);
    picture.residents.push_back(resident(8, 8, 5));
    picture.residents.back().life.parents[1] = 2;
    CHECK(by(GLFW_KEY_C, 7, true) == 8);
    CHECK(by(GLFW_KEY_C, 8, true) == 7);
    CHECK(by(GLFW_KEY_U, 8) == 5);
    CHECK(by(GLFW_KEY_U, 8, true) == 2);
}

TEST_CASE("a key shows the museum and then goes through its creatures",
          "[studio][shortcuts][preserve]") {
    const test::StudioFixture studio;
    PreservePicture picture;
    picture.museum = std::make_shared<const std::vector<MuseumPiece>>(3);
    const std::filesystem::path file;
    const Pins pins;
    PreserveView view{.picture = picture, .file = file, .picked = nullptr, .pins = pins};
    const auto press = [&](bool shift) {
        FrameContext frame = studio.frame();
        frame.preserve = &view;
        Requests out;
        press_shortcut({GLFW_KEY_G, false, shift}, false, frame, out);
        return out;
    };
    CHECK(test::asked<ShowList>(press(false)).list == WorldList::kMuseum);
    view.list = WorldList::kMuseum;
    CHECK(test::asked<ChoosePiece>(press(false)).index == 1);
    CHECK(test::asked<ChoosePiece>(press(true)).index == 2);
    view.piece = 2;
    CHECK(test::asked<ChoosePiece>(press(false)).index == 0);
    picture.museum = std::make_shared<const std::vector<MuseumPiece>>();
    CHECK(test::was_asked<ShowList>(press(false)));
}

TEST_CASE("going back goes through all snapshots before the present tick",
          "[studio][shortcuts][preserve]") {
    const test::StudioFixture studio;
    PreservePicture picture;
    picture.snapshots =
        std::make_shared<const std::vector<std::uint64_t>>(std::vector<std::uint64_t>{0, 60, 90});
    const std::filesystem::path file = "pond.cambrian";
    const Pins pins;
    const PreserveView view{.picture = picture, .file = file, .pins = pins};
    for (const auto& [tick, back] : {std::pair{100, 90}, {90, 60}, {60, 0}, {0, 0}}) {
        picture.tick = static_cast<std::uint64_t>(tick);
        FrameContext frame = studio.frame();
        frame.preserve = &view;
        Requests out;
        press_shortcut({GLFW_KEY_Z, true}, false, frame, out);
        CHECK(test::asked<BranchFrom>(out).tick == static_cast<std::uint64_t>(back));
    }
}

}  // namespace
}  // namespace cambrian
