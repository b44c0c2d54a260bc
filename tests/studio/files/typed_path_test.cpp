#include "studio/files/typed_path.h"

#include "support/catch.h"
#include "support/temporary_directory.h"

#include <cstdlib>
#include <string>

namespace cambrian {
namespace {

namespace fs = std::filesystem;

// A variable of the environment for one test.
class Variable {
public:
    Variable(const char* name, const fs::path& value) : name_(name) {
        const char* before = std::getenv(name);
        if (before != nullptr) before_ = before;
        known_ = before != nullptr;
        setenv(name, value.c_str(), 1);
    }
    ~Variable() { known_ ? setenv(name_, before_.c_str(), 1) : unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::string before_;
    bool known_ = false;
};

struct Typing {
    TemporaryDirectory folder;
    FileBrowser files;

    explicit Typing(FileTask task) {
        files.task = task;
        files.listing.folder = folder.path();
        fs::create_directory(folder / "runs");
    }
    TypedPath read(const char* text) const { return typed_path(files, text); }
};

TEST_CASE("a name to save under gets its ending, unless it has one", "[studio][typed_path]") {
    const Typing typing(FileTask::kSaveCreature);
    CHECK(typing.read("kept").path == typing.folder / "kept.creature.json");
    CHECK(typing.read(" kept ").path == typing.folder / "kept.creature.json");
    CHECK(typing.read("kept.card.png").path == typing.folder / "kept.card.png");
    CHECK(typing.read("runs/kept").path == typing.folder / "runs" / "kept.creature.json");
    CHECK(typing.read("/tmp/kept").path == "/tmp/kept.creature.json");
    CHECK(typing.read("kept").fault.empty());
}

TEST_CASE("what is no name is refused, and says why", "[studio][typed_path]") {
    for (const FileTask task : {FileTask::kOpen, FileTask::kSaveSettings}) {
        const Typing typing(task);
        for (const char* text : {"", "  ", ".", "..", "nowhere/kept"}) {
            INFO(text);
            CHECK_FALSE(typing.read(text).fault.empty());
        }
    }
    const Typing typing(FileTask::kSaveSettings);
    CHECK(typing.read(".toml").fault == "A name is missing before .toml.");
    CHECK(typing.read("nowhere/kept").fault ==
          "There is no folder " + (typing.folder / "nowhere").string() + ".");
}

TEST_CASE("a typed folder is entered", "[studio][typed_path]") {
    for (const FileTask task : {FileTask::kOpen, FileTask::kSaveSettings}) {
        const Typing typing(task);
        for (const char* text : {"runs", "runs/", "./runs", "/tmp", "~"}) {
            INFO(text);
            const Variable home("HOME", typing.folder.path());
            CHECK(typing.read(text).folder);
            CHECK(typing.read(text).fault.empty());
        }
    }
}

TEST_CASE("a tilde is the user's folder", "[studio][typed_path]") {
    const Typing typing(FileTask::kOpen);
    const Variable home("HOME", typing.folder.path());
    CHECK(typing.read("~/runs/a.toml").path == typing.folder / "runs" / "a.toml");
    CHECK(with_home("~") == typing.folder.path());
    CHECK(with_home("a~b") == "a~b");
    CHECK(with_home("~other/x") == "~other/x");
}

TEST_CASE("pictures go where the desktop keeps them", "[studio][typed_path]") {
    const TemporaryDirectory folder;
    const Variable home("HOME", folder.path());
    const Variable config("XDG_CONFIG_HOME", folder / "config");
    CHECK(pictures_folder() == fs::current_path());
    fs::create_directory(folder / "Pictures");
    CHECK(pictures_folder() == folder / "Pictures");
    fs::create_directory(folder / "config");
    fs::create_directory(folder / "Bilder");
    put_text(folder / "config" / "user-dirs.dirs",
             "# comment\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n");
    CHECK(pictures_folder() == folder / "Bilder");
}

}  // namespace
}  // namespace cambrian
