#include "persist/experiment/file_dimensions.h"

#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "persist/sqlite/read_only_database.h"

namespace cambrian {
namespace {

constexpr std::size_t kMostSettingsText = 100'000;  // bytes

int dimensions_of_experiment(const std::filesystem::path& path) {
    int dimensions = 2;
    try {
        read_database(path, [&dimensions](const Database& database) {
            Statement row = database.prepare("SELECT toml FROM settings ORDER BY id LIMIT 1");
            if (row.step()) dimensions = dimensions_of_settings(row.text(0, kMostSettingsText));
        });
    } catch (const DatabaseError&) {
        return 2;
    }
    return dimensions;
}

}  // namespace

int dimensions_of_file(const std::filesystem::path& path) {
    if (path.extension() == ".cambrian") return dimensions_of_experiment(path);
    if (path.extension() != ".toml") {
        const Result<std::string> text = read_creature_text(path);
        return text ? dimensions_of_creature(*text) : 2;
    }
    const Result<SettingsText> text = read_settings_text(path);
    return text ? dimensions_of_settings(text->text) : 2;
}

}  // namespace cambrian
