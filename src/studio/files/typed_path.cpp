#include "studio/files/typed_path.h"

#include "core/files/file_io.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/page_document.h"
#include "studio/files/clip_maker.h"
#include "studio/files/file_service.h"

#include <fmt/core.h>

#include <cstdlib>
#include <sstream>
#include <system_error>

namespace cambrian {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostListBytes = 100'000;
constexpr std::string_view kPicturesLine = "XDG_PICTURES_DIR=\"";

bool is_folder(const fs::path& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

fs::path folder_in(const char* variable) {
    const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
    return value == nullptr ? fs::path() : fs::path(value);
}

// Returns the folder that the desktop's list of the user's folders names for pictures, or nothing.
fs::path listed_pictures() {
    const fs::path set = folder_in("XDG_CONFIG_HOME");
    const fs::path list = (set.is_absolute() ? set : home_folder() / ".config") / "user-dirs.dirs";
    const Result<std::string> text = read_file(list, kMostListBytes);
    if (!text) return {};
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(kPicturesLine) || !line.ends_with('"')) continue;
        line = line.substr(kPicturesLine.size(), line.size() - kPicturesLine.size() - 1);
        constexpr std::string_view home = "$HOME/";
        return line.starts_with(home) ? home_folder() / line.substr(home.size()) : fs::path(line);
    }
    return {};
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

bool has_ending(const std::string& name, FileTask task) {
    return name.ends_with(ending_of(task)) || (is_of_clips(task) && is_clip_name(name)) ||
           (task == FileTask::kSaveCreature &&
            (name.ends_with(kCreatureEnding) || is_card_name(name) || is_page_path(name)));
}

bool is_only_an_ending(const std::string& name, FileTask task) {
    return name == ending_of(task) || (is_of_clips(task) && name == ".mp4") ||
           name == kCardEnding || name == ".png" || name == kPageEnding;
}

}  // namespace

fs::path home_folder() {
    return folder_in("HOME");
}

fs::path with_home(std::string_view path) {
    const fs::path home = home_folder();
    if (home.empty() || !(path == "~" || path.starts_with("~/"))) return path;
    return path.size() <= 2 ? home : home / path.substr(2);
}

fs::path pictures_folder() {
    for (const fs::path& folder : {listed_pictures(), home_folder() / "Pictures"}) {
        if (folder.is_absolute() && is_folder(folder)) return folder;
    }
    return fs::current_path();
}

TypedPath typed_path(const FileBrowser& files, std::string_view typed) {
    const std::string_view text = trimmed(typed);
    if (text.empty()) return {.fault = "A name is missing."};
    if (text == "." || text == "..")
        return {.fault =
                    fmt::format("“{}” is not a name. The arrow leads to the folder above.", text)};
    TypedPath result{.path = files.listing.folder / with_home(text)};
    if (is_folder(result.path)) {
        result.folder = true;
        return result;
    }
    const fs::path parent = result.path.parent_path();
    if (parent != files.listing.folder && !is_folder(parent)) {
        result.fault = fmt::format("There is no folder {}.", parent.string());
        return result;
    }
    const std::string name = result.path.filename().string();
    if (files.task == FileTask::kOpen) return result;
    if (is_only_an_ending(name, files.task)) {
        result.fault = fmt::format("A name is missing before {}.", name);
        return result;
    }
    if (!has_ending(name, files.task)) result.path += ending_of(files.task);
    return result;
}

}  // namespace cambrian
