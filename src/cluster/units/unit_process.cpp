#include "cluster/units/unit_process.h"

#include "core/files/file_descriptor.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-identifier-naming): POSIX's name

namespace cambrian {
namespace {

constexpr const char* kThisProgram = "/proc/self/exe";

Error cannot_start(int code) {
    return Error{"cannot compute a unit in a process of its own: " +
                 std::generic_category().message(code)};
}

// Uses files in memory instead of pipes, so that neither process waits for the other to read.
FileDescriptor memory_file(const char* name) {
    return FileDescriptor(::memfd_create(name, MFD_CLOEXEC));
}

int spawn_unit(int input, int output, pid_t& process) {
    std::array<char, 9> program{"cambrian"};
    std::array<char, 7> subcommand{"worker"};
    std::array<char, 7> option{"--unit"};
    const std::array<char*, 4> arguments{program.data(), subcommand.data(), option.data(), nullptr};
    posix_spawn_file_actions_t actions{};
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    const int code =
        ::posix_spawn(&process, kThisProgram, &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    return code;
}

// Waits until the process has ended. It keeps its number until then, so no other process is ended
// by mistake.
void wait_for(pid_t process, const std::stop_token& stop) {
    const std::stop_callback end(stop, [process] { ::kill(process, SIGKILL); });
    siginfo_t ended{};
    while (::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT) != 0 &&
           errno == EINTR) {
    }
}

std::string all_of(int file) {
    std::string text;
    std::array<char, 65536> buffer{};
    for (off_t at = 0;;) {
        const ssize_t count = ::pread(file, buffer.data(), buffer.size(), at);
        if (count <= 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
        at += count;
    }
}

ChildEnd end_of(int status, int output) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return {true, "signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")", ""};
    }
    if (WEXITSTATUS(status) != 0)
        return {true, "exit status " + std::to_string(WEXITSTATUS(status)), ""};
    return {false, "", all_of(output)};
}

}  // namespace

Result<ChildEnd> run_unit_process(std::string_view question, const std::stop_token& stop) {
    const FileDescriptor input = memory_file("question");
    const FileDescriptor output = memory_file("answer");
    if (!input.is_open() || !output.is_open()) return cannot_start(errno);
    if (const int code = write_all(input.get(), question); code != 0) return cannot_start(code);
    ::lseek(input.get(), 0, SEEK_SET);
    pid_t process = -1;
    if (const int code = spawn_unit(input.get(), output.get(), process); code != 0)
        return cannot_start(code);
    wait_for(process, stop);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0) {
        if (errno != EINTR) return cannot_start(errno);
    }
    return end_of(status, output.get());
}

}  // namespace cambrian
