#include "core/database_companions.h"

#include <string>
#include <unistd.h>

namespace cambrian {

void remove_companions(const std::filesystem::path& database) {
    for (const std::string_view ending : kDatabaseCompanions)
        ::unlink((database.string() + std::string(ending)).c_str());
}

}  // namespace cambrian
