#include "app/messages.h"

#include <cstdio>

namespace cambrian {

void say(std::string_view message) {
    std::fprintf(stderr, "cambrian: %.*s\n", static_cast<int>(message.size()), message.data());
}

ExitStatus fail(const Error& error, ExitStatus status) {
    say(error.message);
    return status;
}

void print_line(std::string_view line) {
    std::printf("%.*s\n", static_cast<int>(line.size()), line.data());
    std::fflush(stdout);
}

}  // namespace cambrian
