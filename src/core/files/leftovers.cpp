#include "core/files/leftovers.h"

#include "core/files/file_descriptor.h"
#include "core/text/parsed_number.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace cambrian {

TemporaryName temporary_name(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix)) return {};
    name.remove_prefix(prefix.size());
    const std::size_t dash = name.find('-');
    if (dash == std::string_view::npos) return {};
    return {parsed_number<pid_t>(name.substr(0, dash)).value_or(0), name.substr(dash + 1)};
}

bool is_leftover(const std::filesystem::path& path, pid_t maker) {
    if (maker <= 0) return false;
    if (maker != ::getpid() && (::kill(maker, 0) == 0 || errno != ESRCH)) return false;
    const FileDescriptor held(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    return held.is_open() && (::flock(held.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK);
}

}  // namespace cambrian
