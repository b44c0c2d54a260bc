#include "app/trial/clip_file.h"

#include "core/spawn_group.h"
#include "core/text/number_text.h"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

extern char** environ;  // NOLINT(readability-identifier-naming): POSIX's name

namespace cambrian {
namespace {

constexpr std::size_t kLongestComplaint = 400;  // bytes of ffmpeg's error message that are kept

void close_pipe(int& pipe) {
    if (pipe >= 0) ::close(pipe);
    pipe = -1;
}

std::vector<std::string> encoder_of(const std::filesystem::path& path) {
    if (path.extension() == ".gif")
        return {"-filter_complex",
                "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=none", "-f",
                "gif"};
    return {"-c:v",    "libx264",   "-crf",       "18", "-pix_fmt",
            "yuv420p", "-movflags", "+faststart", "-f", "mp4"};
}

std::vector<std::string> arguments_of(const std::filesystem::path& target,
                                      const std::filesystem::path& temporary, int width, int height,
                                      double frames_a_second) {
    std::vector<std::string> arguments = {"ffmpeg",       "-nostdin",
                                          "-hide_banner", "-loglevel",
                                          "error",        "-y",
                                          "-f",           "rawvideo",
                                          "-pix_fmt",     "rgb24",
                                          "-s",           fmt::format("{}x{}", width, height),
                                          "-r",           short_text(frames_a_second),
                                          "-i",           "pipe:0"};
    for (std::string& argument : encoder_of(target))
        arguments.push_back(std::move(argument));
    // The prefix prevents a name from being read as a protocol or an option.
    arguments.push_back("file:" + temporary.string());
    return arguments;
}

// The redirections of the child's ends of the pipes.
class SpawnActions {
public:
    SpawnActions() { ::posix_spawn_file_actions_init(&actions_); }
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;

    void put(int file, int as) { ::posix_spawn_file_actions_adddup2(&actions_, file, as); }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

// Starts the process; returns 0 or the error code.
int spawn(const std::vector<std::string>& arguments, int input, int errors, int& process) {
    std::vector<std::string> kept = arguments;
    std::vector<char*> pointers;
    pointers.reserve(kept.size() + 1);
    for (std::string& argument : kept)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    SpawnActions actions;
    actions.put(input, STDIN_FILENO);
    actions.put(errors, STDERR_FILENO);
    const SpawnGroup group;
    return ::posix_spawnp(&process, pointers.front(), actions.get(), group.get(), pointers.data(),
                          environ);
}

Error spawn_failure(int code) {
    if (code == ENOENT)
        return Error{
            "clips are made by ffmpeg, which is not installed (Debian: apt install "
            "ffmpeg); pictures (*.png) need nothing more"};
    return Error{"ffmpeg cannot be started: " + std::generic_category().message(code)};
}

}  // namespace

bool is_clip_name(const std::filesystem::path& path) {
    return path.extension() == ".mp4" || path.extension() == ".gif";
}

Result<std::unique_ptr<ClipFile>> ClipFile::open(const std::filesystem::path& path, int width,
                                                 int height, double frames_a_second) {
    auto file = PendingFile::beside(path);
    if (!file) return file.error();
    const auto arguments = arguments_of(path, file->path(), width, height, frames_a_second);
    std::unique_ptr<ClipFile> clip(new ClipFile(std::move(*file), path.string()));
    const Status started = clip->start(arguments);
    if (!started) return started.error();
    return clip;
}

Status ClipFile::start(const std::vector<std::string>& arguments) {
    std::array<int, 2> to{};
    std::array<int, 2> from{};
    if (::pipe2(to.data(), O_CLOEXEC) != 0) return spawn_failure(errno);
    pictures_ = to[1];
    if (::pipe2(from.data(), O_CLOEXEC) != 0) {
        const int code = errno;
        ::close(to[0]);
        return spawn_failure(code);
    }
    complaints_ = from[0];
    const int code = spawn(arguments, to[0], from[1], process_);
    ::close(to[0]);
    ::close(from[1]);
    if (code == 0) return {};
    process_ = -1;
    return spawn_failure(code);
}

Status ClipFile::add(const Image& picture) {
    std::size_t written = 0;
    while (written < picture.rgb.size()) {
        const ssize_t count =
            ::write(pictures_, picture.rgb.data() + written, picture.rgb.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return failure();
        written += static_cast<std::size_t>(count);
    }
    return {};
}

Status ClipFile::finish() {
    close_pipe(pictures_);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return failure();
    return file_.commit();
}

// Returns what ffmpeg wrote to its standard error.
Status ClipFile::failure() {
    close_pipe(pictures_);
    std::string words(kLongestComplaint, '\0');
    const ssize_t count = ::read(complaints_, words.data(), words.size());
    words.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    words = words.substr(0, words.find('\n'));
    return Error{fmt::format("cannot make {}: ffmpeg {}", name_,
                             words.empty() ? "failed" : "says " + words)};
}

ClipFile::~ClipFile() {
    close_pipe(pictures_);
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    close_pipe(complaints_);
}

}  // namespace cambrian
