#include "core/files/private_folder.h"

#include "core/files/leftovers.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <mutex>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace cambrian {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFolderPrefix = "cambrian-";

bool is_own_folder(const fs::path& path) {
    struct stat facts {};
    return ::lstat(path.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode) &&
           facts.st_uid == ::geteuid();
}

void remove_leftovers() {
    std::error_code unreadable;
    fs::directory_iterator entry(temporary_folder(), unreadable);
    for (; !unreadable && entry != fs::directory_iterator(); entry.increment(unreadable)) {
        const std::string name = entry->path().filename().string();
        const pid_t maker = temporary_name(name, kFolderPrefix).maker;
        std::error_code ignored;
        if (maker > 0 && is_own_folder(entry->path()) && is_leftover(entry->path(), maker))
            fs::remove_all(entry->path(), ignored);
    }
}

Result<fs::path> make_folder(const std::string& name) {
    std::string path = (temporary_folder() / (name + "-XXXXXX")).string();
    if (::mkdtemp(path.data()) != nullptr) return fs::path(path);
    return Error{of_temporary_folder(std::generic_category().message(errno))};
}

}  // namespace

fs::path temporary_folder() {
    const char* const named = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe)
    return named != nullptr && *named != '\0' ? named : "/tmp";
}

std::string of_temporary_folder(const std::string& reason) {
    return fmt::format("the temporary folder {}: {}", temporary_folder().string(), reason);
}

Result<PrivateFolder> PrivateFolder::make() {
    static std::mutex one_at_a_time;  // a new folder counts as left until it is locked
    const std::lock_guard guard(one_at_a_time);
    remove_leftovers();
    Result<fs::path> path = make_folder(fmt::format("{}{}", kFolderPrefix, ::getpid()));
    if (!path) return path.error();
    FileDescriptor lock(::open(path->c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY));
    if (lock.is_open()) ::flock(lock.get(), LOCK_EX | LOCK_NB);
    return PrivateFolder(*std::move(path), std::move(lock));
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
}

Result<fs::path> make_lasting_private_folder() {
    return make_folder(std::string(kFolderPrefix) + "rescued");
}

}  // namespace cambrian
