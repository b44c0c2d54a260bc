#include "studio/preserve/preserve_controller.h"

#include "studio_run.h"

namespace cambrian {
namespace {

// The studio with a folder for its preserve.
class PreserveRun : public test::StudioRun {
public:
    PreserveRun() {
        studio.use_assets(std::filesystem::path(CAMBRIAN_SOURCE_DIR) / "assets");
        studio.remember_in(state());
    }
    std::filesystem::path state() const { return folder.path() / "state"; }
    bool open() const { return studio.frame_context().preserve != nullptr; }
    // Runs frames until the background has nothing left to do.
    void settle() {
        studio.update(0.0, 0.001);
        REQUIRE(frames_until([&] { return open() || !studio.animating(); }));
        studio.update(0.0, 0.001);
    }
};

constexpr BeginPreserve kRandomPreserve = {.founders = FounderChoice::kRandom};

TEST_CASE("a preserve that is closed while it is being opened does not appear",
          "[studio][preserve]") {
    PreserveRun run;
    run.ask(kRandomPreserve);
    run.ask(ClosePreserve{});
    run.settle();
    CHECK_FALSE(run.open());
    run.ask(kRandomPreserve);
    run.settle();
    CHECK(run.open());
}

TEST_CASE("picking by hand is not left for a preserve that is still being opened",
          "[studio][preserve]") {
    PreserveRun run;
    run.studio.show_founders();
    run.ask(kRandomPreserve);
    run.ask(ToggleHandPicking{});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().picking != nullptr; }));
    for (int frame = 0; frame < 500; ++frame) {
        run.studio.update(0.0, 0.001);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK_FALSE(run.open());
    CHECK(run.studio.frame_context().picking != nullptr);
}

TEST_CASE("beginning twice begins one preserve and moves none aside", "[studio][preserve]") {
    PreserveRun run;
    run.ask(kRandomPreserve);
    run.ask(kRandomPreserve);
    run.settle();
    CHECK(run.open());
    CHECK(std::filesystem::exists(run.state() / "preserve.cambrian"));
    CHECK_FALSE(std::filesystem::exists(run.state() / "preserve-before.cambrian"));
}

TEST_CASE("a new meadow has the ground that was asked for", "[studio][preserve]") {
    for (const char* kind : {"hills", "rough", "stairs"}) {
        PreserveRun run;
        run.ask(BeginPreserve{FounderChoice::kWalkers, false, {.kind = kind, .height = 0.1}});
        run.settle();
        REQUIRE(run.open());
        const PreserveView& preserve = *run.studio.frame_context().preserve;
        CHECK(preserve.founding->world.environment.terrain.kind == kind);
        CHECK(preserve.picture.area.ground != nullptr);
    }
    PreserveRun water;
    water.ask(BeginPreserve{FounderChoice::kSwimmers, false, {.kind = "hills"}});
    water.settle();
    REQUIRE(water.open());
    CHECK(water.studio.frame_context().preserve->picture.area.ground == nullptr);
}

TEST_CASE("a settings file of a preserve begins one with its settings and its seed",
          "[studio][preserve]") {
    PreserveRun run;
    const auto path = run.folder.path() / "lake.toml";
    std::ofstream(path) << "[run]\nseed = 77\n[preserve]\nwidth = 31.0\n";
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().preserve_card.open; }));
    CHECK(run.studio.frame_context().preserve_card.plan.settings == path);
    run.ask(kRandomPreserve);
    run.settle();
    REQUIRE(run.open());
    CHECK(run.studio.frame_context().preserve->founding->seed == 77);
    CHECK(run.studio.frame_context().preserve->founding->preserve.width == 31.0);
    run.ask(TogglePreserveCard{});
    run.studio.update(0.0, 0.001);
    CHECK(run.studio.frame_context().preserve_card.plan.settings.empty());
    CHECK(run.studio.frame_context().preserve_card.before);
}

TEST_CASE("a settings file of a preserve with an error is a notice", "[studio][preserve]") {
    PreserveRun run;
    const auto path = run.folder.path() / "lake.toml";
    std::ofstream(path) << "[preserve]\nwidth = -1.0\n";
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().window.notice != nullptr; }));
    CHECK_THAT(run.studio.frame_context().window.notice->text,
               Catch::Contains("lake.toml: line 2, [preserve] width"));
    CHECK_FALSE(run.studio.frame_context().preserve_card.open);
}

}  // namespace
}  // namespace cambrian
