#include "fuzz/scratch.h"

namespace cambrian::test {
namespace {

constexpr std::size_t kPage = 512;  // bytes
constexpr int kMostPatches = 32;

}  // namespace

std::filesystem::path scratch_folder() {
    const std::filesystem::path memory = "/dev/shm";
    return std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
}

std::string with_patched_pages(std::string file, ByteSource bytes) {
    for (int i = 0; i < kMostPatches && !bytes.empty(); ++i) {
        const std::size_t page = kPage * bytes.below(file.size() / kPage);
        const std::size_t place = page + bytes.below(kPage);
        const std::string_view text = bytes.text().substr(0, file.size() - place);
        if (text.empty()) {
            file.replace(page, kPage, file, kPage * bytes.below(file.size() / kPage), kPage);
        } else {
            file.replace(place, text.size(), text);
        }
    }
    return file;
}

}  // namespace cambrian::test
