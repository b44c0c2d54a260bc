#include "core/files/database_companions.h"

#include <string>
#include <system_error>
#include <unistd.h>

namespace cambrian {

bool has_unwritten_changes(const std::filesystem::path& database) {
    for (const char* ending : {"-wal", "-journal"}) {
        std::error_code missing;
        const auto size = std::filesystem::file_size(database.string() + ending, missing);
        if (!missing && size > 0) return true;
    }
    return false;
}

void remove_companions(const std::filesystem::path& database) {
    for (const std::string_view ending : kDatabaseCompanions)
        ::unlink((database.string() + std::string(ending)).c_str());
}

}  // namespace cambrian
