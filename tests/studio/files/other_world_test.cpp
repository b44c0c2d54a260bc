#include "core/files/file_io.h"
#include "persist/settings/settings_file.h"
#include "studio_run.h"

#include <catch2/catch.hpp>

namespace cambrian::test {
namespace {

const char* const kSwimmers = "[goal]\nbehavior = \"swimming\"\n[environment]\ndimensions = 3\n";

}  // namespace

TEST_CASE("a file of the other world is told from one that cannot be read", "[studio][space]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "swim.toml";
    REQUIRE(write_file(path, kSwimmers));
    CHECK(std::holds_alternative<FileElsewhere>(load_file(path, kinds(), &spatial_kinds())));
    CHECK(std::holds_alternative<SettingsLoaded>(load_file(path, spatial_kinds(), &kinds())));
    CHECK(std::holds_alternative<FileFailed>(load_file(path, kinds())));
    REQUIRE(write_file(path, std::string(kSwimmers) + "gravity = \"much\"\n"));
    CHECK(std::holds_alternative<FileFailed>(load_file(path, kinds(), &spatial_kinds())));
}

TEST_CASE("the studio leaves for the world of a file that it opens", "[studio][space]") {
    const TemporaryDirectory folder;
    StudioController studio({{}, small_experiment(), {}, {}}, kinds(), {.threads = {.workers = 1}},
                            folder.path() / "log", &spatial_kinds());
    const auto path = folder.path() / "swim.toml";
    REQUIRE(write_file(path, kSwimmers));
    CHECK_FALSE(studio.files().crossing());
    studio.files().open_now(path, ExhibitSource::kFile);
    REQUIRE(studio.files().crossing());
    CHECK(studio.files().crossing()->file == path);
}

TEST_CASE("the studio runs in space, where preserves are refused in a sentence",
          "[studio][space]") {
    const TemporaryDirectory folder;
    ExperimentSettings settings = plain_defaults(spatial_kinds());
    settings.population.size = 4;
    settings.world.trial.duration = 0.5;
    StudioController studio({{}, settings, {}, {}}, spatial_kinds(), {.threads = {.workers = 1}},
                            folder.path() / "log", &kinds());
    const auto ask = [&studio](auto action) {
        Requests requests;
        requests.ask(std::move(action));
        studio.carry_out(requests);
    };
    ask(TogglePreserveCard{});
    CHECK_FALSE(studio.frame_context().preserve_card.open);
    studio.update(0.0, 0.01);
    REQUIRE(studio.frame_context().window.notice != nullptr);
    CHECK(studio.frame_context().window.notice->text.find("flat") != std::string::npos);
    ask(BeginElsewhere{});
    REQUIRE(studio.files().crossing());
    CHECK(studio.files().crossing()->file.empty());
}

TEST_CASE("settings are remembered in the world they are of", "[studio][space]") {
    const TemporaryDirectory folder;
    CHECK(remembered_dimensions(folder.path()) == 2);
    CHECK(remembered_dimensions({}) == 2);
    Preferences left;
    left.settings = plain_defaults(spatial_kinds());
    REQUIRE(remember(folder.path(), left, spatial_kinds()));
    CHECK(remembered_dimensions(folder.path()) == 3);
    const Preferences found = recall(folder.path(), spatial_kinds());
    CHECK(found.fault.empty());
    CHECK(found.settings.world.environment.dimensions == 3);
}

}  // namespace cambrian::test
