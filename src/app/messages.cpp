#include "app/messages.h"

#include <cstdio>

namespace cambrian {

void say(std::string_view message) {
    std::fprintf(stderr, "cambrian: %.*s\n", static_cast<int>(message.size()), message.data());
}

void say_of(const std::string& file, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "cambrian: %s: %s\n", file.c_str(), warning.c_str());
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
