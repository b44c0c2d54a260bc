#include "core/files/file_io.h"
#include "panel_press.h"
#include "studio/files/recent_runs.h"
#include "studio/panels/cards/start_panel.h"
#include "studio/preferences.h"
#include "studio_run.h"
#include "support/null_imgui.h"
#include "support/temporary_directory.h"

namespace cambrian {
namespace {

using test::StudioRun;

TEST_CASE("the run used last is first, and only so many are kept", "[studio][start]") {
    std::vector<std::filesystem::path> paths;
    for (std::size_t i = 0; i < kMostRecent + 3; ++i)
        use_run(paths, "/runs/" + std::to_string(i) + ".cambrian");
    use_run(paths, "/runs/9.cambrian");
    CHECK(paths.size() == kMostRecent);
    CHECK(paths[0] == "/runs/9.cambrian");
    CHECK(paths[1] == "/runs/14.cambrian");
    CHECK(std::count(paths.begin(), paths.end(), "/runs/9.cambrian") == 1);

    const TemporaryDirectory folder;
    Preferences kept;
    kept.recent = paths;
    REQUIRE(remember(folder.path(), kept, test::kinds()));
    CHECK(recall(folder.path(), test::kinds()).recent == paths);
}

TEST_CASE("a saved run is on the start page with its champion, and opens from there",
          "[studio][start]") {
    StudioRun run;
    const std::filesystem::path file = run.folder.path() / "mine.cambrian";
    const std::filesystem::path broken = run.folder.path() / "broken.cambrian";
    REQUIRE(write_file(broken, "no experiment"));
    test::finish_generations(run, 2);
    run.ask(SaveExperimentFile{file});
    REQUIRE(run.frames_until([&] { return !run.studio.files().recent().empty(); }));
    CHECK(run.studio.files().recent().front() == file);
    std::vector<std::filesystem::path> paths = {broken, file, run.folder.path() / "gone.cambrian"};
    run.studio.files().use_recent(paths);
    run.studio.files().use_challenges(CAMBRIAN_SOURCE_DIR "/assets/challenges");
    run.ask(ToggleStartPage{});
    const StartPage& page = *run.studio.frame_context().files.start;
    REQUIRE(run.frames_until([&] { return page.read; }));
    REQUIRE(page.challenges.size() == 5);
    CHECK(page.challenges[0].filename() == "jump.challenge.toml");
    REQUIRE(page.runs.size() == 3);
    CHECK_FALSE(page.runs[0].readable);
    CHECK(page.runs[1].readable);
    CHECK(page.runs[1].title == "mine");
    CHECK(page.runs[1].account.find("Walking") == 0);
    CHECK(page.runs[1].account.find("2 generations") != std::string::npos);
    CHECK(page.runs[1].champion != nullptr);
    CHECK(page.runs[2].account == "The file is no longer there.");
    run.ask(ForgetRun{broken});
    CHECK(page.runs.size() == 2);
    CHECK(run.studio.files().recent().size() == 2);
    CHECK(std::filesystem::exists(broken));
    run.ask(StartNewRun{});
    run.ask(OpenRun{file});
    CHECK_FALSE(page.open);
}

TEST_CASE("runs that can be opened are buttons, others can be taken off", "[studio][start]") {
    NullImGui gui;
    StartPanel panel;
    const test::StudioFixture studio;
    StartPage page;
    page.open = true;
    page.read = true;
    RecentRun kept{"/a.cambrian", "a", "Walking", true, 0.0, 0, nullptr};
    page.runs = {kept,
                 {"/b.cambrian", "b", "The file is no longer there.", false, 0.0, 0, nullptr}};
    SampleLibrary samples;
    FrameContext frame = studio.frame();
    frame.files.start = &page;
    frame.files.samples = &samples;
    const auto pressed = [&](const char* name) {
        Requests out;
        gui.click(name, [&] { panel.draw(frame, out); });
        return out;
    };
    CHECK(test::asked<OpenRun>(pressed("run a")).path == "/a.cambrian");
    CHECK(test::asked<ForgetRun>(pressed("forget b")).path == "/b.cambrian");
    CHECK_FALSE(gui.has("run b"));
    CHECK(test::was_asked<ToggleStartPage>(pressed("Go on")));
    const Requests begun = pressed("Begin a new run");
    CHECK(test::was_asked<StartNewRun>(begun));
    CHECK(test::was_asked<ToggleStartPage>(begun));
}

}  // namespace
}  // namespace cambrian
