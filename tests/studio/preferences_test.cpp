#include "studio/preferences.h"

#include "core/files/file_io.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

namespace cambrian {
namespace {

TEST_CASE("arrangement and settings are restored as they were", "[studio][remembered]") {
    const TemporaryDirectory folder;
    Preferences left;
    left.view.theme = ThemeKind::kLight;
    left.view.look = LookMode::kMechanics;
    left.view.scenery = Scenery::kLight;
    left.view.size = 150;
    left.view.all_settings = true;
    left.view.speed = 0.25;
    left.view.panels.bottom = false;
    left.view.overlays.torques = true;
    left.view.overlays.grid = false;
    left.view.ghosts = GhostChoice::kTenths;
    left.view.tour_taken = true;
    left.view.panels.left_width = 312.0F;
    left.view.quantity = TimelineQuantity::kNeurons;
    left.view.order = TileOrder::kMass;
    left.settings.world.environment.gravity = 1.62;
    left.settings.seed = 99;
    REQUIRE(remember(folder.path() / "new", left, test::kinds()));
    const Preferences found = recall(folder.path() / "new", test::kinds());
    CHECK(found.view == left.view);
    CHECK(found.settings.world.environment == left.settings.world.environment);
    CHECK(found.settings.seed == 99);
}

TEST_CASE("the cluster is restored, with spaces in paths", "[studio][remembered]") {
    const TemporaryDirectory folder;
    Preferences left;
    left.cluster.joined = true;
    left.cluster.login = {"tls://a,tls://b", "lab two", "/home/an a/my = creds", "ca.pem"};
    REQUIRE(remember(folder.path(), left, test::kinds()));
    CHECK(recall(folder.path(), test::kinds()).cluster == left.cluster);
    left.cluster = {};
    REQUIRE(remember(folder.path(), left, test::kinds()));
    CHECK(recall(folder.path(), test::kinds()).cluster == ClusterMemory{});
    CHECK(parse_cluster("joined\n= yes\nserver =\n\xff = 1\n") == ClusterMemory{});
}

TEST_CASE("missing or damaged state gives the defaults", "[studio][remembered]") {
    const TemporaryDirectory folder;
    CHECK(recall(folder.path(), test::kinds()) == Preferences{});
    CHECK(recall({}, test::kinds()) == Preferences{});
    put_text(folder / "view.conf",
             "theme\n= = =\nspeed = 1e300\nscenery = yes\ninterface-size = 9000\nfollow = "
             "?\n\xff\xfe\n");
    put_text(folder / "experiment.toml", "[environment]\ngravity = \"heavy\"\n");
    const Preferences found = recall(folder.path(), test::kinds());
    CHECK(found.view.speed == 1.0);
    CHECK(found.view.size == 100);
    CHECK(found.view.scenery == Scenery::kAutomatic);
    CHECK(found.settings == ExperimentSettings{});
}

TEST_CASE("settings that cannot be read keep their bytes under a name that a notice tells",
          "[studio][remembered]") {
    const TemporaryDirectory folder;
    const std::string bytes = "[environment]\ngravity = \"heavy\"\n";
    for (const char* aside : {"experiment-unreadable-1.toml", "experiment-unreadable-2.toml"}) {
        put_text(folder / "experiment.toml", bytes);
        const Preferences found = recall(folder.path(), test::kinds());
        CHECK_THAT(found.fault,
                   Catch::Contains((folder / aside).string()) && Catch::Contains("gravity"));
        REQUIRE(remember(folder.path(), found, test::kinds()));
        CHECK(*read_file(folder / aside, 1000) == bytes);
        CHECK(recall(folder.path(), test::kinds()).fault.empty());
    }
}

}  // namespace
}  // namespace cambrian
