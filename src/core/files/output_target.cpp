#include "core/files/output_target.h"

#include "core/files/file_errors.h"
#include "core/text/parsed_number.h"

#include <linux/magic.h>
#include <optional>
#include <string>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <system_error>

namespace cambrian {
namespace {

constexpr int kMostLinks = 40;  // the limit of the operating system

std::filesystem::path folder_of(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.parent_path();
    return folder.empty() ? "." : folder;
}

bool is_of_processes(const std::filesystem::path& folder) {
    struct statfs facts {};
    return ::statfs(folder.c_str(), &facts) == 0 && facts.f_type == PROC_SUPER_MAGIC;
}

// Returns whether the folder belongs to this process or one of its threads.
bool is_own(const std::filesystem::path& folder) {
    std::error_code unknown;
    const std::string own = std::filesystem::canonical("/proc/self", unknown).string();
    const std::string name = folder.string();
    return !unknown && (name == own + "/fd" || name.starts_with(own + "/task/"));
}

std::optional<int> number_of(const std::string& text) {
    const auto number = parsed_number<int>(text);
    return number && *number >= 0 ? number : std::nullopt;
}

// Returns the descriptor that a name in a folder of open files denotes; nothing for other names.
Result<std::optional<int>> descriptor_of(const std::filesystem::path& name,
                                         const std::filesystem::path& asked) {
    if (!is_of_processes(folder_of(name))) return std::optional<int>();
    std::error_code unknown;
    const std::filesystem::path folder = std::filesystem::canonical(folder_of(name), unknown);
    if (unknown || folder.filename() != "fd") return std::optional<int>();
    if (!is_own(folder)) return cannot_write(asked, "it is an open file of another program");
    const std::optional<int> descriptor = number_of(name.filename().string());
    struct stat facts {};
    if (!descriptor || ::fstat(*descriptor, &facts) != 0)
        return write_outcome(asked, EBADF).error();
    return descriptor;
}

Result<OutputTarget::Kind> kind_of(const std::filesystem::path& path,
                                   const std::filesystem::path& asked) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0 || S_ISREG(facts.st_mode))
        return OutputTarget::Kind::kFile;
    if (S_ISDIR(facts.st_mode)) return OutputTarget::Kind::kFolder;
    if (S_ISCHR(facts.st_mode) || S_ISFIFO(facts.st_mode)) return OutputTarget::Kind::kStream;
    return cannot_write(asked, S_ISBLK(facts.st_mode) ? "it is a disk" : "it is a socket");
}

}  // namespace

Result<OutputTarget> output_target(const std::filesystem::path& asked) {
    std::filesystem::path path = asked;
    for (int links = 0; links <= kMostLinks; ++links) {
        const Result<std::optional<int>> descriptor = descriptor_of(path, asked);
        if (!descriptor) return descriptor.error();
        if (*descriptor)
            return OutputTarget{path, OutputTarget::Kind::kDescriptor, descriptor->value()};
        std::error_code none;
        const std::filesystem::path link = std::filesystem::read_symlink(path, none);
        if (none) {
            const Result<OutputTarget::Kind> kind = kind_of(path, asked);
            if (!kind) return kind.error();
            return OutputTarget{path, *kind};
        }
        path = link.is_absolute() ? link : path.parent_path() / link;
    }
    return write_outcome(asked, ELOOP).error();
}

}  // namespace cambrian
