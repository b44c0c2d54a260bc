#include "core/files/private_folder.h"

#include "core/files/file_io.h"
#include "support/catch.h"
#include "support/temporary_directory.h"

#include <cstdlib>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace cambrian;

namespace {

// Changes the temporary folder during its scope.
class TemporaryFolderIn {
public:
    explicit TemporaryFolderIn(const std::filesystem::path& path) {
        const char* const before = std::getenv("TMPDIR");
        if (before != nullptr) before_ = before;
        ::setenv("TMPDIR", path.c_str(), 1);
    }
    ~TemporaryFolderIn() {
        if (before_.empty()) {
            ::unsetenv("TMPDIR");
        } else {
            ::setenv("TMPDIR", before_.c_str(), 1);
        }
    }
    TemporaryFolderIn(const TemporaryFolderIn&) = delete;
    TemporaryFolderIn& operator=(const TemporaryFolderIn&) = delete;

private:
    std::string before_;
};

std::string process_that_is_gone() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return std::to_string(child);
}

}  // namespace

TEST_CASE("a private folder is this user's and goes with its scope", "[core][private_folder]") {
    const TemporaryDirectory place;
    const TemporaryFolderIn here(place.path());
    {
        const auto folder = PrivateFolder::make();
        REQUIRE(folder);
        struct stat facts {};
        REQUIRE(::stat(folder->path().c_str(), &facts) == 0);
        CHECK((facts.st_mode & 0777) == 0700);
        CHECK(folder->path().parent_path() == place.path());
        put_text(folder->path() / "copy", "data");
        REQUIRE(PrivateFolder::make());  // does not take the first one for left
        CHECK(std::filesystem::exists(folder->path() / "copy"));
    }
    CHECK(std::filesystem::is_empty(place.path()));
}

TEST_CASE("what a killed process left is removed with the next folder", "[core][private_folder]") {
    const TemporaryDirectory place;
    const TemporaryFolderIn here(place.path());
    const auto left = place / ("cambrian-" + process_that_is_gone() + "-abcdef");
    const auto living = place / ("cambrian-" + std::to_string(::getppid()) + "-abcdef");
    std::filesystem::create_directory(left);
    std::filesystem::create_directory(living);
    std::filesystem::create_directory(place / "cambrian-rescued-abcdef");
    std::filesystem::create_directory_symlink(living, left.string() + "-link");
    put_text(left / "copy", "data");
    REQUIRE(PrivateFolder::make());
    CHECK_FALSE(std::filesystem::exists(left));
    CHECK(std::filesystem::exists(living));
    CHECK(std::filesystem::exists(place / "cambrian-rescued-abcdef"));
}

TEST_CASE("a temporary folder that is missing is named", "[core][private_folder]") {
    const TemporaryDirectory place;
    const TemporaryFolderIn nowhere(place / "none");
    const auto folder = PrivateFolder::make();
    REQUIRE_FALSE(folder);
    CHECK(folder.error().message ==
          "the temporary folder " + (place / "none").string() + ": No such file or directory");
    CHECK_FALSE(make_lasting_private_folder());
}
