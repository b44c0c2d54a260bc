// Calls a fuzz target with every file in the given folders, without libFuzzer. It works with any
// compiler and any sanitizer.

#include "core/files/file_io.h"
#include "fuzz/fuzz_target.h"

#include <filesystem>
#include <string>

namespace {

constexpr std::size_t kMostBytes = 100'000'000;

// Returns the number of files.
int replay_folder(const std::filesystem::path& folder) {
    int replayed = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto bytes = cambrian::read_file(entry.path(), kMostBytes);
        if (!bytes) continue;
        std::fprintf(stderr, "%s\n", entry.path().c_str());
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
        ++replayed;
    }
    return replayed;
}

}  // namespace

int main(int argc, char** argv) {
    int replayed = 0;
    for (int i = 1; i < argc; ++i)
        replayed += replay_folder(argv[i]);
    std::printf("%d files\n", replayed);
    return replayed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
