#include "panel_press.h"
#include "studio/panels/bar/evolve_bar.h"
#include "studio/panels/cards/file_panel.h"
#include "studio/panels/generations/population_panel.h"
#include "studio/panels/generations/timeline_panel.h"
#include "studio/panels/preserve/new_preserve_card.h"
#include "studio/panels/viewport/transport_bar.h"
#include "studio/panels/viewport/viewport_panel.h"
#include "support/null_imgui.h"
#include "support/temporary_directory.h"

#include <fstream>

namespace cambrian {
namespace {

using test::click;

TEST_CASE("pressing Evolve asks to evolve, once", "[studio][evolve_bar]") {
    NullImGui gui;
    EvolveBar bar;
    const test::StudioFixture studio;
    const Requests out = click(gui, bar, studio, "Evolve");
    CHECK(out.all().size() == 1);
    CHECK(test::was_asked<ToggleEvolution>(out));
}

TEST_CASE("while evolving the button says Pause and no single step is offered",
          "[studio][evolve_bar]") {
    NullImGui gui;
    EvolveBar bar;
    test::StudioFixture studio;
    studio.snapshot().status = EngineStatus::kRunning;
    CHECK(test::was_asked<ToggleEvolution>(click(gui, bar, studio, "Pause")));
    CHECK(click(gui, bar, studio, "Step one generation").all().empty());
}

TEST_CASE("a menu opens and its entry makes a request", "[studio][main_menu]") {
    NullImGui gui;
    EvolveBar bar;
    const test::StudioFixture studio;
    click(gui, bar, studio, "File");
    CHECK(test::was_asked<OpenFilePanel>(click(gui, bar, studio, "Open…")));
}

TEST_CASE("the menus act on the grid or the world that is displayed", "[studio][main_menu]") {
    NullImGui gui;
    EvolveBar bar;
    test::StudioFixture studio;
    ExperimentSettings edited = studio.editor().draft();
    edited.population.size += 1;
    studio.editor().edit(edited, "population.size");
    studio.editor().finish();
    FrameContext frame = studio.frame();
    const auto choose = [&](const char* menu, const char* item) {
        Requests out;
        const auto draw = [&] { bar.draw(frame, out); };
        gui.click(menu, draw);
        gui.click(item, draw);
        return out;
    };
    CHECK(test::was_asked<UndoEdit>(choose("Edit", "Undo")));
    studio.show_grid(9);
    studio.focus_cell(4);
    frame.picking = studio.frame().picking;
    CHECK(test::asked<SaveCell>(choose("File", "Save creature…")).cell == 4);

    const PreservePicture picture = [] {
        PreservePicture made;
        made.residents.resize(1);
        return made;
    }();
    const std::filesystem::path file = "pond.cambrian";
    const Pins pins;
    const PreserveView view{
        .picture = picture, .file = file, .picked = &picture.residents[0], .pins = pins};
    frame.picking = nullptr;
    frame.preserve = &view;
    CHECK(test::was_asked<SaveResident>(choose("File", "Save creature…")));
    CHECK_FALSE(test::was_asked<UndoEdit>(choose("Edit", "Undo")));
}

TEST_CASE("the transport plays, restarts and changes the speed", "[studio][transport_bar]") {
    NullImGui gui;
    TransportBar bar;
    test::StudioFixture studio;
    studio.show_crawler();
    CHECK(test::was_asked<TogglePlayback>(click(gui, bar, studio, "Play")));
    CHECK(test::was_asked<RestartPlayback>(click(gui, bar, studio, "Restart")));
    CHECK(test::asked<ChangeView>(click(gui, bar, studio, "4×")).view.speed == 4.0);
}

TEST_CASE("the transport steps back, and a press of the time bar seeks that time",
          "[studio][transport_bar]") {
    NullImGui gui;
    TransportBar bar;
    test::StudioFixture studio;
    studio.show_crawler();
    CHECK(test::was_asked<StepPlaybackBack>(click(gui, bar, studio, "Back one tick")));
    const std::uint64_t sought =
        test::asked<SeekPlayback>(click(gui, bar, studio, "time bar")).tick;
    CHECK(sought >= studio.playback().length() / 2 - 2);
    CHECK(sought <= studio.playback().length() / 2 + 2);
}

TEST_CASE("a click on the timeline shows that generation's champion", "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    for (int i = 0; i < 21; ++i)
        studio.finish_generation(0.1 * i);
    const Requests out = click(gui, panel, studio, "timeline");
    CHECK(test::asked<ShowChampion>(out).generation == 10);
}

TEST_CASE("a stagnant run offers suggestions and changes nothing by itself", "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    for (int i = 0; i < 21; ++i)
        studio.finish_generation(0.5);
    Requests unasked;
    gui.frame([&] { panel.draw(studio.frame(), unasked); });
    CHECK_FALSE(gui.has("What to change"));
    studio.snapshot().history.back().generations_without_progress = 20;
    gui.frame([&] { panel.draw(studio.frame(), unasked); });
    CHECK(unasked.all().empty());
    CHECK(test::asked<ShowSuggestions>(click(gui, panel, studio, "What to change")).shown);
}

TEST_CASE("a click on a tile shows its creature", "[studio][population]") {
    NullImGui gui;
    PopulationPanel panel;
    test::StudioFixture studio;
    studio.finish_generation(1.0);
    const Requests out = click(gui, panel, studio, "tile 0");
    CHECK(test::asked<ShowIndividual>(out).creature.individual == studio.snapshot().population[0]);
}

TEST_CASE("the viewport draws the displayed creature and can grab it", "[studio][viewport]") {
    NullImGui gui;
    ViewportPanel panel(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    Requests out;
    const auto draw = [&] { panel.draw(studio.frame(), out); };
    gui.frame(draw);
    CHECK(panel.scene().shapes.size() > studio.playback().creature().phenotype().parts.size());
    const Rect& area = gui.place("viewport");
    const Vec2 body = panel.camera().to_screen(
        studio.playback().creature().motion().poses()[0].position.head<2>(),
        {static_cast<double>(area.width), static_cast<double>(area.height)});
    gui.move_to({area.x + static_cast<float>(body.x()), area.y + static_cast<float>(body.y())});
    gui.frame(draw);
    CHECK(test::asked<ShowHighlight>(out).highlight.part == 0);
    gui.press();
    gui.frame(draw);
    CHECK(test::asked<PokePart>(out).part == 0);
}

TEST_CASE("the light is drawn in the viewport and moved by dragging it", "[studio][viewport]") {
    NullImGui gui;
    ViewportPanel panel(nullptr);
    test::StudioFixture studio;
    ExperimentSettings lit = studio.editor().draft();
    lit.world.environment.has_light = true;
    lit.world.environment.light_x = 0.8;
    lit.world.environment.light_y = 1.2;
    studio.editor().replace(lit);
    studio.show_crawler();
    Requests out;
    const auto draw = [&] { panel.draw(studio.frame(), out); };
    gui.frame(draw);
    const std::size_t dark = panel.scene().shapes.size();
    studio.playback().creature().set_environment(lit.world.environment);
    studio.playback().creature().tick();
    gui.frame(draw);
    CHECK(panel.scene().shapes.size() > dark);
    const Rect& area = gui.place("viewport");
    const Vec2 sun = panel.camera().to_screen(
        {0.8, 1.2}, {static_cast<double>(area.width), static_cast<double>(area.height)});
    const float x = area.x + static_cast<float>(sun.x());
    const float y = area.y + static_cast<float>(sun.y());
    gui.move_to({x, y});
    gui.frame(draw);
    gui.press();
    gui.frame(draw);
    gui.move_to({x + 60.0F, y});
    gui.frame(draw);
    const auto& edit = test::asked<EditSettings>(out);
    CHECK(edit.field == "environment.light-x");
    CHECK(edit.settings.world.environment.light_x > 0.9);
    CHECK(edit.settings.world.environment.light_y == Approx(1.2).margin(0.05));
    CHECK_FALSE(test::was_asked<PokePart>(out));
    CHECK_FALSE(test::was_asked<FinishEdit>(out));
    gui.release();
    gui.frame(draw);
    CHECK(test::was_asked<FinishEdit>(out));
}

TEST_CASE("dragging with the right button stops the camera's following", "[studio][viewport]") {
    NullImGui gui;
    ViewportPanel panel(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    Requests out;
    const auto draw = [&] { panel.draw(studio.frame(), out); };
    gui.frame(draw);
    gui.move_to({400, 200});
    gui.frame(draw);
    gui.press(1);
    gui.frame(draw);
    gui.move_to({460, 230});
    gui.frame(draw);
    CHECK_FALSE(test::asked<ChangeView>(out).view.follow);
}

TEST_CASE("overlays, ghosts and help have buttons in the viewport", "[studio][viewport]") {
    NullImGui gui;
    ViewportPanel panel(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    CHECK(test::asked<ShowHelp>(click(gui, panel, studio, "? viewport")).page == "viewport");
    click(gui, panel, studio, "Overlays");
    const Requests torques = click(gui, panel, studio, "Joint torques");
    CHECK(test::asked<ChangeView>(torques).view.overlays.torques);
    CHECK_FALSE(test::was_asked<PokePart>(torques));
}

TEST_CASE("a choice of ghosts is a click in the viewport", "[studio][viewport]") {
    NullImGui gui;
    ViewportPanel panel(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    click(gui, panel, studio, "Ghosts");
    const Requests out = click(gui, panel, studio, "Every tenth generation");
    CHECK(test::asked<ChangeView>(out).view.ghosts == GhostChoice::kTenths);
}

TEST_CASE("the file panel opens the file that is pressed twice", "[studio][file_panel]") {
    NullImGui gui;
    FilePanel panel;
    test::StudioFixture studio;
    studio.files().open = true;
    studio.files().opened = 1;
    studio.files().listing = {"/creatures", {}, {"a.creature.json", "b.creature.json"}, ""};
    click(gui, panel, studio, "b.creature.json");
    const Requests out = click(gui, panel, studio, "b.creature.json");
    CHECK(test::asked<LoadFile>(out).path == "/creatures/b.creature.json");
    CHECK(test::was_asked<CloseFilePanel>(out));
}

TEST_CASE("a saved creature gets its file name ending", "[studio][file_panel]") {
    NullImGui gui;
    FilePanel panel;
    test::StudioFixture studio;
    studio.files().open = true;
    studio.files().opened = 1;
    studio.files().task = FileTask::kSaveCreature;
    studio.files().suggested_name = "hopper";
    studio.files().listing.folder = "/creatures";
    const Requests out = click(gui, panel, studio, "Save");
    CHECK(test::asked<SaveCreatureFile>(out).path == "/creatures/hopper.creature.json");
}

TEST_CASE("a creature can be saved as a card and back, by a button or by its name",
          "[studio][file_panel]") {
    NullImGui gui;
    FilePanel panel;
    test::StudioFixture studio;
    studio.files().open = true;
    studio.files().opened = 1;
    studio.files().task = FileTask::kSaveCreature;
    studio.files().suggested_name = "hopper.creature.json";
    studio.files().listing.folder = "/creatures";
    const auto saved_as = [&] {
        return test::asked<SaveCreatureFile>(click(gui, panel, studio, "Save")).path;
    };
    click(gui, panel, studio, "Card");
    CHECK(saved_as() == "/creatures/hopper.card.png");
    click(gui, panel, studio, "Page");
    CHECK(saved_as() == "/creatures/hopper.html");
    click(gui, panel, studio, "Creature file");
    CHECK(saved_as() == "/creatures/hopper.creature.json");
    studio.files().opened = 2;
    studio.files().suggested_name = "posted.png";
    CHECK(saved_as() == "/creatures/posted.png");
}

TEST_CASE("a clip is saved in the kind, length, speed and size that are chosen",
          "[studio][file_panel]") {
    NullImGui gui;
    FilePanel panel;
    test::StudioFixture studio;
    studio.files().open = true;
    studio.files().opened = 1;
    studio.files().task = FileTask::kSaveClip;
    studio.files().suggested_name = "hopper.gif";
    studio.files().listing.folder = "/creatures";
    const auto saved = [&] { return test::asked<SaveClip>(click(gui, panel, studio, "Save")); };
    SaveClip clip = saved();
    CHECK(clip.path == "/creatures/hopper.gif");
    CHECK(clip.choice.format->label == "GIF");
    CHECK(clip.choice.width == 640);
    CHECK(clip.choice.seconds == 5.0);
    CHECK(clip.choice.speed == 1.0);
    click(gui, panel, studio, "Moving card");
    click(gui, panel, studio, "10 s");
    click(gui, panel, studio, "½ ×");
    clip = saved();
    CHECK(clip.path == "/creatures/hopper.card.png");
    CHECK(clip.choice.card);
    CHECK(clip.choice.height == 800);
    CHECK(clip.choice.seconds == 10.0);
    CHECK(clip.choice.speed == 0.5);
    studio.files().opened = 2;
    studio.files().suggested_name = "hopper";
    CHECK(saved().path == "/creatures/hopper.card.png");
    studio.files().opened = 3;
    studio.files().suggested_name = "posted.gif";
    click(gui, panel, studio, "1080p");
    clip = saved();
    CHECK_FALSE(clip.choice.card);
    CHECK(clip.choice.height == 1080);
    CHECK(test::asked<OpenFilePanel>(click(gui, panel, studio, "Card")).task ==
          FileTask::kSaveCreature);
}

TEST_CASE("a kind of clip that cannot be written here cannot be chosen", "[studio][file_panel]") {
    NullImGui gui;
    FilePanel panel;
    test::StudioFixture studio;
    studio.files().open = true;
    studio.files().opened = 1;
    studio.files().task = FileTask::kSaveClip;
    studio.files().suggested_name = "hopper.gif";
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    click(gui, panel, studio, "MP4");
    CHECK(test::asked<SaveClip>(click(gui, panel, studio, "Save")).choice.format->label == "GIF");
    ::setenv("PATH", path.c_str(), 1);
}

TEST_CASE("a file is replaced only when Save is pressed again", "[studio][file_panel]") {
    NullImGui gui;
    FilePanel panel;
    test::StudioFixture studio;
    const TemporaryDirectory folder;
    const auto taken = folder.path() / "hopper.toml";
    std::ofstream(taken) << "";
    studio.files().open = true;
    studio.files().opened = 1;
    studio.files().task = FileTask::kSaveSettings;
    studio.files().suggested_name = "hopper.toml";
    studio.files().listing.folder = folder.path();
    CHECK(click(gui, panel, studio, "Save").all().empty());
    gui.frame([&] {
        Requests out;
        panel.draw(studio.frame(), out);
    });
    CHECK(gui.has("replace warning"));
    const Requests again = click(gui, panel, studio, "Save");
    CHECK(test::asked<SaveSettingsFile>(again).path == taken);
    CHECK(test::was_asked<CloseFilePanel>(again));
}

TEST_CASE("an experiment is saved in its own file at once", "[studio][file_panel]") {
    NullImGui gui;
    FilePanel panel;
    test::StudioFixture studio;
    const TemporaryDirectory folder;
    const auto own = folder.path() / "run.cambrian";
    std::ofstream(own) << "";
    studio.files().open = true;
    studio.files().opened = 1;
    studio.files().task = FileTask::kSaveExperiment;
    studio.files().suggested_name = "run.cambrian";
    studio.files().own_file = own;
    studio.files().listing.folder = folder.path();
    CHECK(test::asked<SaveExperimentFile>(click(gui, panel, studio, "Save")).path == own);
}

TEST_CASE(
    "a preserve with settings of a file keeps their edges and has samples that can live there",
    "[studio][preserve]") {
    NullImGui gui(700.0F, 700.0F);
    NewPreserveCard card;
    test::StudioFixture studio;
    CHECK(click(gui, card, studio, "Edges that meet").all().empty());
    studio.preserve_card().plan = {"lake.toml", true};
    const auto begun = test::asked<BeginPreserve>(click(gui, card, studio, "Begin"));
    CHECK_FALSE(begun.wraps);
    CHECK(begun.founders == FounderChoice::kWalkers);
}

TEST_CASE("a preserve begins with the edges that were chosen", "[studio][preserve]") {
    NullImGui gui(700.0F, 700.0F);
    NewPreserveCard card;
    const test::StudioFixture studio;
    CHECK_FALSE(test::asked<BeginPreserve>(click(gui, card, studio, "Begin")).wraps);
    CHECK(click(gui, card, studio, "Edges that meet").all().empty());
    const auto begun = test::asked<BeginPreserve>(click(gui, card, studio, "Begin"));
    CHECK(begun.wraps);
    CHECK(begun.founders == FounderChoice::kSwimmers);
    test::press_key(gui, card, studio, ImGuiKey_LeftArrow);
    CHECK_FALSE(test::asked<BeginPreserve>(click(gui, card, studio, "Begin")).wraps);
}

TEST_CASE("the ground of a meadow is chosen with its founders, and water has none",
          "[studio][preserve]") {
    NullImGui gui(700.0F, 760.0F);
    NewPreserveCard card;
    test::StudioFixture studio;
    studio.preserve_card().on_ground = {FounderChoice::kWalkers};
    const auto begun = [&] {
        return test::asked<BeginPreserve>(click(gui, card, studio, "Begin"));
    };
    CHECK(click(gui, card, studio, "The walkers among the samples").all().empty());
    CHECK(begun().ground.is_flat());
    CHECK(click(gui, card, studio, "Hills").all().empty());
    CHECK(begun().ground.kind == "hills");
    test::press_key(gui, card, studio, ImGuiKey_PageDown);
    CHECK(begun().ground.kind == "rough");
    CHECK(click(gui, card, studio, "The swimmers among the samples").all().empty());
    CHECK(begun().ground.is_flat());
}

TEST_CASE("what can be done with the creature on display is offered below its name",
          "[studio][panels]") {
    NullImGui gui(900.0F, 600.0F);
    ViewportPanel panel(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    const auto pressed = [&](const char* name) { return click(gui, panel, studio, name); };
    CHECK_FALSE(test::asked<EvolveShown>(pressed("Evolve from it")).in_its_world);
    CHECK_FALSE(gui.has("Evolve in its world"));  // it is the experiment's
    CHECK(test::asked<BeginPreserve>(pressed("Into a preserve")).founders == FounderChoice::kShown);
    CHECK(test::asked<OpenFilePanel>(pressed("Save it")).task == FileTask::kSaveCreature);
    ExperimentSettings moon = studio.editor().draft();
    moon.world.environment.gravity = 1.62;
    studio.editor().replace(moon);
    CHECK(test::asked<EvolveShown>(pressed("Evolve in its world")).in_its_world);
    studio.show_grid(4);
    gui.forget_places();
    Requests out;
    gui.frame([&] { panel.draw(studio.frame(), out); });
    CHECK_FALSE(gui.has("Evolve from it"));
}

}  // namespace
}  // namespace cambrian
