#include "app/command_line.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    try {
        return static_cast<int>(cambrian::run_command_line(argc, argv));
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "cambrian: %s\n", failure.what());
        return static_cast<int>(cambrian::ExitStatus::kFailed);
    }
}
