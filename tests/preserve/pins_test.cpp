// Pins of a preserve and their file.
#include "preserve/pins.h"

#include "persist/sqlite/database.h"
#include "preserve/engine/preserve_engine.h"
#include "support/temporary_directory.h"
#include "support/wait_for.h"
#include "worlds.h"

namespace cambrian {
namespace {

using namespace test;

TEST_CASE("pins come back from their text, and no other text is one", "[preserve][pins]") {
    for (const Pins& pins : {Pins(), Pins{{}, true}, Pins{{3, 17}, false}, Pins{{1}, true}})
        CHECK(pins_of(pins_text(pins)) == pins);
    for (const char* text : {"", "2", "1 x", "0 3,4", "-1", "0 "})
        CHECK_FALSE(pins_of(text));
}

TEST_CASE("pins come back from their file, and damaged ones are forgotten with a warning",
          "[preserve][pins]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const Pins pins{{3, 7}, true};
    KeptWorld world = kept_in(path, small_world());
    REQUIRE(world.file->keep_pins({{5}, false}));
    REQUIRE(world.file->keep_pins(pins));
    world.file.reset();
    {
        const auto opened = PreserveFile::open(path, kinds());
        REQUIRE(opened);
        CHECK(opened->pins == pins);
        CHECK(opened->warnings.empty());
    }
    Database(path, Database::Access::kWrite)
        .execute("UPDATE facts SET value = 'three' WHERE name = 'pins'");
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->pins == Pins());
    CHECK(opened->warnings == std::vector<std::string>{"its pins are damaged, and forgotten"});
}

TEST_CASE("a preserve that is closed keeps its pins", "[preserve][pins][threads]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    KeptWorld world = kept_in(path, small_world());
    {
        PreserveEngine engine({std::move(world.preserve), std::move(world.file), {}},
                              {.workers = 1});
        engine.send(KeepPins{{{2, 4}, false}});
    }
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->pins == Pins{{2, 4}, false});
}

}  // namespace
}  // namespace cambrian
