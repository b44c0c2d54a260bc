#include "core/files/pending_file.h"

#include "core/files/file_io.h"
#include "core/files/file_lock.h"
#include "support/catch.h"
#include "support/temporary_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace cambrian;

namespace {

// Returns the id of a process that has ended.
pid_t gone_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

mode_t mode_of(const std::filesystem::path& path) {
    struct stat facts {};
    REQUIRE(::stat(path.c_str(), &facts) == 0);
    return facts.st_mode & 0777;
}

}  // namespace

TEST_CASE("a pending file takes its name only when committed", "[core][pending_file]") {
    const TemporaryDirectory folder;
    put_text(folder / "target", "old");
    {
        const auto pending = PendingFile::beside(folder / "target");
        REQUIRE(pending);
        put_text(pending->path(), "half");
        CHECK(get_text(folder / "target") == "old");
    }
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
    auto pending = PendingFile::beside(folder / "target");
    REQUIRE(pending);
    put_text(pending->path(), "new");
    REQUIRE(pending->commit());
    CHECK(get_text(folder / "target") == "new");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
    CHECK_FALSE(PendingFile::beside(folder.path()));
    CHECK_FALSE(PendingFile::beside("/dev/null"));
}

TEST_CASE("what a process that is gone left of a file is taken away", "[core][pending_file]") {
    const TemporaryDirectory folder;
    const std::string stale = ".cambrian-" + std::to_string(gone_process()) + "-";
    for (const char* name : {"1", "1-journal", "1-wal", "1-shm", "23"})
        put_text(folder / (stale + name), "half");
    const std::string living = ".cambrian-" + std::to_string(::getppid()) + "-1";
    const std::string own_of_before = ".cambrian-" + std::to_string(::getpid()) + "-4000000";
    put_text(folder / living, "half");
    put_text(folder / own_of_before, "half");
    for (const char* name : {".cambrian-", ".cambrian-1x-1", ".cambrian-99-", "cambrian-1-1"})
        put_text(folder / name, "another's");
    REQUIRE(write_file(folder / "file", "x"));
    CHECK_FALSE(std::filesystem::exists(folder / (stale + "1")));
    CHECK_FALSE(std::filesystem::exists(folder / (stale + "1-journal")));
    CHECK_FALSE(std::filesystem::exists(folder / (stale + "23")));
    CHECK_FALSE(std::filesystem::exists(folder / own_of_before));
    CHECK(std::filesystem::exists(folder / living));
    CHECK(folder.size() == 6);  // with the four of other processes
}

TEST_CASE("a file that is written to elsewhere, out of sight, is not taken away",
          "[core][pending_file]") {
    const TemporaryDirectory folder;
    const std::filesystem::path held =
        folder / (".cambrian-" + std::to_string(gone_process()) + "-1");
    put_text(held, "half");
    const FileDescriptor file(::open(held.c_str(), O_RDONLY | O_CLOEXEC));
    REQUIRE(::flock(file.get(), LOCK_EX) == 0);
    const auto pending = PendingFile::beside(folder / "one");
    REQUIRE(write_file(folder / "another", "x"));
    CHECK(std::filesystem::exists(held));
    CHECK(std::filesystem::exists(pending->path()));
}

TEST_CASE("a replaced file keeps its permissions, a new one has the usual ones",
          "[core][pending_file]") {
    const TemporaryDirectory folder;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    REQUIRE(write_file(folder / "new", "x"));
    CHECK(mode_of(folder / "new") == (0666 & ~mask));
    for (const mode_t mode : {0600U, 0640U, 0755U, 0664U, 0444U}) {
        REQUIRE(::chmod((folder / "new").c_str(), mode) == 0);
        const auto pending = PendingFile::beside(folder / "new");
        CHECK((mode_of(pending->path()) & ~mode & 077) == 0);
        REQUIRE(write_file(folder / "new", "y"));
        CHECK(mode_of(folder / "new") == mode);
    }
}

TEST_CASE("a file that is locked is not replaced", "[core][pending_file]") {
    const TemporaryDirectory folder;
    put_text(folder / "file", "old");
    std::filesystem::create_hard_link(folder / "file", folder / "other");
    {
        const auto lock = FileLock::take(folder / "file");
        REQUIRE(lock);
        for (const char* name : {"file", "other"})
            CHECK_THAT(write_file(folder / name, "new").error().message,
                       Catch::EndsWith("open in another window or program"));
        CHECK_FALSE(FileLock::take(folder / "other"));
    }
    CHECK(get_text(folder / "file") == "old");
    CHECK(write_file(folder / "file", "new"));
    CHECK(FileLock::take(folder / "other"));
}

TEST_CASE("only regular files are locked", "[core][file_lock]") {
    const TemporaryDirectory folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK_THAT(FileLock::take(folder / "pipe").error().message, Catch::Contains("regular file"));
    CHECK_THAT(FileLock::take(folder.path()).error().message, Catch::Contains("regular file"));
    CHECK_THAT(FileLock::take(folder / "none").error().message, Catch::Contains("No such file"));
    CHECK(FileLock::check_free(folder / "none"));
}

TEST_CASE("companions of a file that is gone are taken away, too", "[core][pending_file]") {
    const TemporaryDirectory folder;
    const std::string stale = ".cambrian-" + std::to_string(gone_process()) + "-1";
    for (const char* ending : {"-wal", "-shm", "-journal"})
        put_text(folder / (stale + ending), "half");
    put_text(folder / (stale + "-other"), "not ours");
    REQUIRE(PendingFile::beside(folder / "target"));
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a database whose changes are only in its log is not committed", "[core][pending_file]") {
    const TemporaryDirectory folder;
    auto pending = PendingFile::beside(folder / "target");
    REQUIRE(pending);
    put_text(pending->path().string() + "-wal", "changes");
    const Status refused = pending->commit();
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, Catch::Contains("its last changes cannot be written"));
    CHECK_FALSE(std::filesystem::exists(folder / "target"));
    put_text(pending->path().string() + "-wal", "");
    put_text(pending->path().string() + "-shm", "index");
    REQUIRE(pending->commit());
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}
