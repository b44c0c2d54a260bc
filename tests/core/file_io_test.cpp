#include "core/files/file_io.h"

#include "support/catch.h"
#include "support/temporary_directory.h"

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace cambrian;

namespace {

// Limits the size of files during its lifetime. For a writer, this is the same as a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit tight{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &tight);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

}  // namespace

TEST_CASE("what is written is read back byte for byte", "[core][file_io]") {
    const TemporaryDirectory folder;
    std::string bytes(100000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<char>(i * 31 % 256);
    REQUIRE(write_file(folder / "a", bytes));
    REQUIRE(read_file(folder / "a", 100000));
    CHECK(*read_file(folder / "a", 100000) == bytes);
    REQUIRE(write_file(folder / "a", ""));
    CHECK(read_file(folder / "a", 10)->empty());
    CHECK(folder.size() == 1);
}

TEST_CASE("a missing file is named in the message", "[core][file_io]") {
    const TemporaryDirectory folder;
    const auto read = read_file(folder / "gone.json", 100);
    REQUIRE_FALSE(read);
    CHECK_THAT(read.error().message, Catch::Contains("gone.json: No such file"));
}

TEST_CASE("only regular files are read", "[core][file_io]") {
    const TemporaryDirectory folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK_THAT(read_file(folder.path(), 100).error().message,
               Catch::EndsWith("is not a regular file"));
    CHECK_THAT(read_file(folder / "pipe", 100).error().message,
               Catch::EndsWith("is not a regular file"));
}

TEST_CASE("a file above the limit is refused before it is read", "[core][file_io]") {
    const TemporaryDirectory folder;
    put_text(folder / "huge", "");
    std::filesystem::resize_file(folder / "huge", 100'000'000'000);  // a sparse file of 100 GB
    const auto read = read_file(folder / "huge", 4'000'000);
    REQUIRE_FALSE(read);
    CHECK_THAT(read.error().message, Catch::Contains("too large: 100000.0 MB, limit 4.0 MB"));
}

TEST_CASE("writing on a full disk keeps the old file and leaves nothing behind",
          "[core][file_io]") {
    const TemporaryDirectory folder;
    put_text(folder / "kept", "old");
    Status written;
    {
        const FullDisk full(4096);
        written = write_file(folder / "kept", std::string(100000, 'x'));
    }
    REQUIRE_FALSE(written);
    CHECK_THAT(written.error().message, Catch::Contains("cannot write"));
    CHECK(get_text(folder / "kept") == "old");
    CHECK(folder.size() == 1);
}

TEST_CASE("writing where nothing can be written fails with the reason", "[core][file_io]") {
    const TemporaryDirectory folder;
    CHECK_THAT(write_file(folder / "no/such/folder/a", "x").error().message,
               Catch::Contains("No such file or directory"));
    CHECK_FALSE(write_file(folder.path(), "x"));
    CHECK(folder.size() == 0);
}

TEST_CASE("a name as long as names may be can be written", "[core][file_io]") {
    const TemporaryDirectory folder;
    const std::string longest(255, 'n');
    CHECK(write_file(folder / longest, "x"));
    CHECK(get_text(folder / longest) == "x");
}

TEST_CASE("a replaced file is a new one, so a reader of the old keeps all of it",
          "[core][file_io]") {
    const TemporaryDirectory folder;
    put_text(folder / "a", "old");
    std::ifstream reader(folder / "a");
    REQUIRE(write_file(folder / "a", "new text"));
    std::string seen;
    reader >> seen;
    CHECK(seen == "old");
    CHECK(get_text(folder / "a") == "new text");
}

TEST_CASE("a device is written to, not replaced", "[core][file_io]") {
    const TemporaryDirectory folder;
    // The link leads to a device. If write_file() renamed over the link, it would become a file.
    std::filesystem::create_symlink("/dev/null", folder / "device");
    CHECK(write_file(folder / "device", "x"));
    CHECK(std::filesystem::is_symlink(folder / "device"));
    std::filesystem::create_symlink("/dev/full", folder / "full");
    CHECK_THAT(write_file(folder / "full", "x").error().message,
               Catch::Contains("No space left on device"));
}

TEST_CASE("a link to a file stays a link and its target gets the text", "[core][file_io]") {
    const TemporaryDirectory folder;
    put_text(folder / "target", "old");
    std::filesystem::create_symlink("target", folder / "link");
    REQUIRE(write_file(folder / "link", "new"));
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(get_text(folder / "target") == "new");
}

TEST_CASE("the start of a file is as much as there is", "[core][file_io]") {
    const TemporaryDirectory folder;
    put_text(folder / "file", "abcdef");
    CHECK(read_start(folder / "file", 3).value() == "abc");
    CHECK(read_start(folder / "file", 99).value() == "abcdef");
    CHECK_FALSE(read_start(folder / "none", 3));
}
