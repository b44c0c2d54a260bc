#include "studio/files/file_browser.h"

#include "support/catch.h"
#include "support/temporary_directory.h"

#include <fstream>

namespace cambrian {
namespace {

TEST_CASE("a folder lists its folders and the files that suit the task, by name",
          "[studio][file_browser]") {
    const TemporaryDirectory folder;
    for (const char* name : {"b.creature.json", "a.creature.json", "x.toml", "notes.txt", ".hidden",
                             "d.card.png", "e.png"})
        std::ofstream(folder.path() / name) << "x";
    std::filesystem::create_directory(folder.path() / "more");
    const FolderListing open = list_folder(folder.path(), FileTask::kOpen);
    CHECK(open.folders == std::vector<std::string>{"more"});
    CHECK(open.files == std::vector<std::string>{"a.creature.json", "b.creature.json", "d.card.png",
                                                 "e.png", "x.toml"});
    CHECK(list_folder(folder.path(), FileTask::kSaveCreature).files ==
          std::vector<std::string>{"a.creature.json", "b.creature.json", "d.card.png"});
    CHECK(list_folder(folder.path(), FileTask::kSaveSettings).files ==
          std::vector<std::string>{"x.toml"});
}

TEST_CASE("a folder that cannot be read says why", "[studio][file_browser]") {
    const FolderListing listing = list_folder("/no/such/folder", FileTask::kOpen);
    CHECK_FALSE(listing.problem.empty());
    CHECK(listing.files.empty());
}

TEST_CASE("a name that is taken gets a number before its ending", "[studio][file_browser]") {
    const TemporaryDirectory folder;
    const std::string ending = ".creature.json";
    const auto named = [&] { return free_name(folder.path(), "hopper.creature.json", ending); };
    CHECK(named() == "hopper.creature.json");
    std::ofstream(folder.path() / "hopper.creature.json") << "{}";
    CHECK(named() == "hopper-2.creature.json");
    std::ofstream(folder.path() / "hopper-2.creature.json") << "{}";
    CHECK(named() == "hopper-3.creature.json");
}

}  // namespace
}  // namespace cambrian
