#include "core/output_stream.h"

#include "core/file_io.h"
#include "support/catch.h"
#include "support/temporary_directory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace cambrian;

TEST_CASE("a file written piece by piece is there when finished and not before",
          "[core][output_stream]") {
    const TemporaryDirectory folder;
    put_text(folder / "file", "old");
    for (const bool finished : {false, true}) {
        auto stream = OutputStream::open(folder / "file");
        REQUIRE(stream);
        REQUIRE(stream->write("one "));
        REQUIRE(stream->write("two"));
        CHECK(get_text(folder / "file") == "old");
        if (finished) REQUIRE(stream->finish());
    }
    CHECK(get_text(folder / "file") == "one two");
    CHECK(folder.size() == 1);
}

TEST_CASE("an open file of this process is written to where it is", "[core][output_stream]") {
    const TemporaryDirectory folder;
    put_text(folder / "file", "abc");
    const FileDescriptor file(::open((folder / "file").c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    const FileDescriptor reading(::open((folder / "file").c_str(), O_RDONLY | O_CLOEXEC));
    const std::string number = std::to_string(file.get());
    std::filesystem::create_symlink("/dev/fd/" + number, folder / "link");
    for (const std::filesystem::path& path :
         {std::filesystem::path("/dev/fd/" + number),
          std::filesystem::path("/proc/self/fd/" + number), folder / "link"})
        REQUIRE(write_file(path, "d"));
    CHECK(get_text(folder / "file") == "abcddd");
    const std::filesystem::path unwritable = "/dev/fd/" + std::to_string(reading.get());
    CHECK_THAT(check_writable(unwritable).error().message, Catch::Contains("Bad file descriptor"));
    CHECK_THAT(write_file(unwritable, "x").error().message, Catch::Contains("Bad file descriptor"));
    CHECK_THAT(write_file("/dev/fd/999", "x").error().message,
               Catch::Contains("Bad file descriptor"));
    CHECK_THAT(write_file("/dev/fd/x", "x").error().message,
               Catch::Contains("Bad file descriptor"));
    CHECK_THAT(write_file("/proc/1/fd/0", "x").error().message, Catch::Contains("/proc/1/fd/0"));
    CHECK(std::filesystem::is_symlink(folder / "link"));
}

TEST_CASE("a link to nothing yet, however many, leads to a new file", "[core][output_stream]") {
    const TemporaryDirectory folder;
    std::filesystem::create_directory(folder / "inner");
    std::filesystem::create_symlink("inner/second", folder / "first");
    std::filesystem::create_symlink("../new", folder / "inner/second");
    REQUIRE(write_file(folder / "first", "x"));
    CHECK(get_text(folder / "new") == "x");
    CHECK(std::filesystem::is_symlink(folder / "first"));
    std::filesystem::create_symlink("round", folder / "round");
    CHECK_THAT(write_file(folder / "round", "x").error().message,
               Catch::Contains("symbolic links"));
}

TEST_CASE("each piece that a device refuses is told", "[core][output_stream]") {
    auto stream = OutputStream::open("/dev/full");
    REQUIRE(stream);
    CHECK_THAT(stream->write("x").error().message,
               Catch::Contains("/dev/full: No space left on device"));
    CHECK(OutputStream::open("/dev/null")->write("x"));
}
