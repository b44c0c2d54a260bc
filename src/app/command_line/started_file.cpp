#include "app/command_line/started_file.h"

#include "core/files/database_companions.h"

#include <system_error>

namespace cambrian {

StartedFile::~StartedFile() {
    if (path_.empty()) return;
    std::error_code unknown;
    std::filesystem::remove(path_, unknown);
    remove_companions(path_);
}

}  // namespace cambrian
