#include "cluster/units/unit_process.h"

#include "cluster/messages/text_for_people.h"
#include "core/files/file_descriptor.h"
#include "core/spawn_group.h"

#include <fmt/core.h>

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
constexpr std::size_t kLongestMessage = 300;  // bytes of an error message

Error cannot_start(int code) {
    return Error{"cannot compute a unit in a process of its own: " +
                 std::generic_category().message(code)};
}

// Uses files in memory instead of pipes, so that neither process waits for the other to read.
FileDescriptor memory_file(const char* name) {
    return FileDescriptor(::memfd_create(name, MFD_CLOEXEC));
}

// The files that the process reads and writes.
struct Streams {
    FileDescriptor question = memory_file("question");
    FileDescriptor answer = memory_file("answer");
    FileDescriptor messages = memory_file("messages");

    bool are_open() const { return question.is_open() && answer.is_open() && messages.is_open(); }
};

int spawn_unit(const Streams& streams, pid_t& process) {
    std::array<char, 9> program{"cambrian"};
    std::array<char, 7> subcommand{"worker"};
    std::array<char, 7> option{"--unit"};
    const std::array<char*, 4> arguments{program.data(), subcommand.data(), option.data(), nullptr};
    posix_spawn_file_actions_t actions{};
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, streams.question.get(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, streams.answer.get(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, streams.messages.get(), STDERR_FILENO);
    const SpawnGroup group;
    const int code =
        ::posix_spawn(&process, kThisProgram, &actions, group.get(), arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    return code;
}

// Waits until the process has ended. The process id stays reserved until then, so that no other
// process is killed by mistake.
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

// Example: "signal 6 (Aborted)".
std::string signal_text(int signal) {
    const std::string text = fmt::format("signal {}", signal);
    const char* description = ::sigdescr_np(signal);
    return description == nullptr ? text : fmt::format("{} ({})", text, description);
}

// Returns the error of a process that refused, with its message.
Error refusal(int status, std::string_view messages) {
    const std::string_view first = messages.substr(0, messages.find('\n'));
    return Error{fmt::format("a process of its own did not compute a unit (exit status {}): {}",
                             status, text_for_people(first, kLongestMessage))};
}

Result<ChildEnd> end_of(int status, const Streams& streams) {
    const std::string messages = all_of(streams.messages.get());
    if (WIFSIGNALED(status)) {
        write_all(STDERR_FILENO, messages);  // prints the message of a failed assertion
        return ChildEnd{true, signal_text(WTERMSIG(status)), ""};
    }
    if (WEXITSTATUS(status) != 0) return refusal(WEXITSTATUS(status), messages);
    return ChildEnd{false, "", all_of(streams.answer.get())};
}

}  // namespace

Result<ChildEnd> run_unit_process(std::string_view question, const std::stop_token& stop) {
    const Streams streams;
    if (!streams.are_open()) return cannot_start(errno);
    const int input = streams.question.get();
    if (const int code = write_all(input, question); code != 0) return cannot_start(code);
    ::lseek(input, 0, SEEK_SET);
    pid_t process = -1;
    if (const int code = spawn_unit(streams, process); code != 0) return cannot_start(code);
    wait_for(process, stop);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0) {
        if (errno != EINTR) return cannot_start(errno);
    }
    return end_of(status, streams);
}

}  // namespace cambrian
