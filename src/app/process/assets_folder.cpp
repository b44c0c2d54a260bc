#include "app/process/assets_folder.h"

#include <system_error>

namespace cambrian {

std::filesystem::path assets_folder() {
    std::error_code failure;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (!failure) {
        std::filesystem::path installed =
            program.parent_path().parent_path() / CAMBRIAN_INSTALLED_ASSETS;
        if (std::filesystem::is_directory(installed, failure)) return installed;
    }
    return CAMBRIAN_ASSETS;
}

}  // namespace cambrian
