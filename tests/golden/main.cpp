// cambrian_golden                prints the digests
// cambrian_golden --write FILE   records them
// cambrian_golden --check FILE   compares them with the recorded ones; status 1 if any differs

#include "core/files/file_io.h"
#include "golden/digest_file.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <span>
#include <string_view>

namespace {

using namespace cambrian;

constexpr std::size_t kMaxRecord = 1 << 20;  // bytes
constexpr std::size_t kMaxShown = 10;        // differences

int fail(const std::string& message) {
    std::fprintf(stderr, "cambrian_golden: %s\n", message.c_str());
    return 1;
}

int write(const char* file) {
    const Status written = write_file(file, golden::text_of(golden::all_digests()));
    return written ? 0 : fail(written.error().message);
}

int check(const char* file) {
    const auto recorded = read_file(file, kMaxRecord);
    if (!recorded) return fail(recorded.error().message);
    const golden::Digests digests = golden::all_digests();
    const auto different = golden::differences(*recorded, digests);
    if (different.empty()) {
        std::printf("%zu digests are as recorded\n", digests.size());
        return 0;
    }
    for (const std::string& line :
         std::span(different).first(std::min(kMaxShown, different.size())))
        std::fprintf(stderr, "%s\n", line.c_str());
    return fail(std::to_string(different.size()) + " of " + std::to_string(digests.size()) +
                " digests are not as in " + file);
}

int run(std::span<char*> arguments) {
    if (arguments.size() == 1)
        return std::fputs(golden::text_of(golden::all_digests()).c_str(), stdout) < 0;
    const std::string_view command = arguments[1];
    if (arguments.size() == 3 && command == "--write") return write(arguments[2]);
    if (arguments.size() == 3 && command == "--check") return check(arguments[2]);
    return fail("usage: cambrian_golden [--write FILE | --check FILE]");
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run({argv, static_cast<std::size_t>(argc)});
    } catch (const std::exception& failure) {
        return fail(failure.what());
    }
}
