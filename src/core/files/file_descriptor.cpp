#include "core/files/file_descriptor.h"

#include <cerrno>
#include <poll.h>
#include <sys/types.h>
#include <unistd.h>

namespace cambrian {
namespace {

// Waits until a stream that was opened as non-blocking accepts more bytes.
void wait_for_room(int file) {
    pollfd waiting{.fd = file, .events = POLLOUT, .revents = 0};
    ::poll(&waiting, 1, -1);
}

}  // namespace

int FileDescriptor::close() {
    if (value_ < 0) return 0;
    return ::close(std::exchange(value_, -1)) == 0 ? 0 : errno;
}

int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EAGAIN) {
            wait_for_room(file);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

}  // namespace cambrian
