#include "core/files/file_io.h"
#include "persist/creature/creature_file.h"
#include "studio/files/sample_library.h"
#include "studio/panels/cards/samples_panel.h"
#include "studio_fixture.h"
#include "support/null_imgui.h"
#include "support/temporary_directory.h"

namespace cambrian {
namespace {

TEST_CASE("samples are listed by title, damaged files last with their reason",
          "[studio][samples]") {
    const TemporaryDirectory folder;
    const CreatureDocument document{unjudged(test::crawler(test::kinds().creature.catalog))};
    for (const char* name : {"small-walker", "crawler"}) {
        const std::string file = std::string(name) + ".creature.json";
        REQUIRE(save_creature(folder.path() / file, document, test::kinds()));
    }
    REQUIRE(write_file(folder.path() / "a-cut.creature.json", R"({"format": "cambr)"));
    REQUIRE(write_file(folder.path() / "notes.txt", "not a creature"));
    std::filesystem::create_directory(folder.path() / "b-folder.creature.json");
    const auto samples = read_samples(folder.path(), test::kinds());
    REQUIRE(samples.size() == 4);
    CHECK(samples[0].path.filename() == "crawler.creature.json");
    CHECK(samples[1].path.filename() == "small-walker.creature.json");
    CHECK(samples[1].phenotype->parts.size() > 1);
    CHECK(samples[2].phenotype == nullptr);
    CHECK(samples[2].account.find("a-cut.creature.json") != std::string::npos);
    CHECK(samples[3].phenotype == nullptr);
    CHECK(read_samples(folder.path() / "missing", test::kinds()).empty());
}

TEST_CASE("every creature that comes with the program can be opened", "[studio][samples]") {
    for (const char* folder : {"/assets/creatures", "/assets/creatures-3d"}) {
        const auto samples = read_samples(std::string(CAMBRIAN_SOURCE_DIR) + folder, test::kinds(),
                                          &test::spatial_kinds());
        CHECK_FALSE(samples.empty());
        for (const Sample& sample : samples) {
            INFO(sample.account);
            CHECK(sample.phenotype != nullptr);
        }
    }
}

TEST_CASE("the sample under the pointer is watched, until the pointer leaves it",
          "[studio][samples]") {
    NullImGui gui;
    SamplesPanel panel;
    const test::StudioFixture studio;
    const auto body = std::make_shared<const Phenotype>(
        express(*test::crawler(test::kinds().creature.catalog), test::kinds().creature, {}, {}));
    SampleLibrary library;
    library.samples = {{"/a.creature.json", "Crawler", "Walking, 2 m", 0.2, body},
                       {"/b.creature.json", "Hopper", "Jumping, 1 m", 0.4, body}};
    FrameContext frame = studio.frame();
    frame.files.samples = &library;
    Requests out;
    const auto draw = [&] { panel.draw(frame, out); };
    gui.frame(draw);
    gui.move_to(gui.place("sample Hopper").center());
    gui.frame(draw);
    CHECK(test::asked<WatchSample>(out).path == "/b.creature.json");
    library.watched = "/b.creature.json";
    gui.move_to({-1.0F, -1.0F});
    gui.frame(draw);
    CHECK(test::asked<WatchSample>(out).path.empty());
}

TEST_CASE("a click on a sample opens it", "[studio][samples]") {
    NullImGui gui;
    SamplesPanel panel;
    const test::StudioFixture studio;
    const auto genome = test::crawler(test::kinds().creature.catalog);
    const auto body =
        std::make_shared<const Phenotype>(express(*genome, test::kinds().creature, {}, {}));
    SampleLibrary library;
    library.open = true;
    library.samples = {{"/a.creature.json", "Crawler", "Walking, 2 m", 0.2, body},
                       {"/b.creature.json", "Hopper", "Jumping, 1 m", 0.4, body},
                       {"/c.creature.json", "Cut", "c.creature.json: E01 line 1", 0.0, nullptr}};
    FrameContext frame = studio.frame();
    frame.files.samples = &library;
    Requests out;
    gui.click("sample Hopper", [&] { panel.draw(frame, out); });
    CHECK(test::asked<LoadFile>(out).path == "/b.creature.json");
    CHECK(test::was_asked<ToggleSamples>(out));
    CHECK(gui.has("damaged samples"));
    CHECK_FALSE(gui.has("sample Cut"));
}

}  // namespace
}  // namespace cambrian
