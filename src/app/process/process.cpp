#include "app/process/process.h"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <pthread.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace cambrian {
namespace {

constexpr rlim_t kUsualStack = 8U << 20U;  // bytes
constexpr rlim_t kLeastStack = 1U << 20U;

// Opens standard streams that were closed, so that no file gets their number and receives results.
// Writing to such a replacement fails.
void open_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
    }
}

// Sets the limit of the stack's size, which threads use too.
Status provide_stack() {
    rlimit stack{};
    if (::getrlimit(RLIMIT_STACK, &stack) != 0) return {};
    if (stack.rlim_cur < kUsualStack) {
        stack.rlim_cur = std::min(kUsualStack, stack.rlim_max);
        ::setrlimit(RLIMIT_STACK, &stack);
    }
    if (stack.rlim_cur < kLeastStack) {
        return Error{
            fmt::format("the stack is limited to {} kB; at least {} kB are needed (ulimit -s)",
                        stack.rlim_cur / 1024, kLeastStack / 1024)};
    }
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, std::min(stack.rlim_cur, kUsualStack));
    ::pthread_setattr_default_np(&attributes);
    ::pthread_attr_destroy(&attributes);
    return {};
}

}  // namespace

Status prepare_process() {
    open_standard_streams();
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return provide_stack();
}

}  // namespace cambrian
