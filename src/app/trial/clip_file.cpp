#include "app/trial/clip_file.h"

#include "core/spawn_group.h"
#include "core/text/number_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

extern char** environ;  // NOLINT(readability-identifier-naming): POSIX's name

namespace cambrian {
namespace {

constexpr std::size_t kLongestComplaint = 400;  // bytes of ffmpeg's error message that are kept
constexpr int kEndPause = 20;                   // ms
constexpr int kMostEndPauses = 50;

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

Status check_frame_rate(const std::filesystem::path& path, double frames_a_second) {
    if (path.extension() != ".gif" || frames_a_second <= kMostGifRate) return {};
    return Error{fmt::format(
        "{}: a GIF shows at most {} frames a second, found {}; browsers slow down faster ones",
        path.string(), short_text(kMostGifRate), short_text(frames_a_second))};
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
    for (const int end : {pictures_, complaints_})
        ::fcntl(end, F_SETFL, O_NONBLOCK);
    if (code == 0) return {};
    process_ = -1;
    return spawn_failure(code);
}

// Both pipes are served at the same time, since ffmpeg reads no pictures while nobody reads its
// messages.
Status ClipFile::add(const Image& picture) {
    std::size_t written = 0;
    while (written < picture.rgb.size()) {
        std::array<pollfd, 2> ends{
            {{pictures_, POLLOUT, 0}, {complaints_, POLLIN, 0}}};  // a closed one is never ready
        if (::poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) return failure();
        if (ends[1].revents != 0) drain();
        if (ends[0].revents == 0) continue;
        const ssize_t count =
            ::write(pictures_, picture.rgb.data() + written, picture.rgb.size() - written);
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0) return failure();
        written += static_cast<std::size_t>(count);
    }
    return {};
}

// Reads what ffmpeg has written to its standard error and keeps the start of it.
void ClipFile::drain() {
    std::array<char, 4096> bytes{};
    for (;;) {
        const ssize_t count = ::read(complaints_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count == 0) close_pipe(complaints_);
        if (count <= 0) return;
        words_.append(bytes.data(),
                      std::min(static_cast<std::size_t>(count), kLongestComplaint - words_.size()));
    }
}

// Waits for a while; returns whether ffmpeg has ended and, if so, its status.
bool ClipFile::wait_for_end(int& status) {
    pollfd messages{complaints_, POLLIN, 0};
    ::poll(&messages, 1, kEndPause);
    if (messages.revents != 0) drain();
    if (::waitpid(process_, &status, WNOHANG) == 0) return false;
    process_ = -1;
    drain();
    return true;
}

Status ClipFile::finish() {
    close_pipe(pictures_);
    int status = 0;
    while (!wait_for_end(status)) {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return failure();
    std::error_code unknown;
    if (std::filesystem::file_size(file_.path(), unknown) == 0) return failure("wrote nothing");
    return file_.commit();
}

// Its message may arrive after it has closed the pipe of pictures.
Status ClipFile::failure(const char* otherwise) {
    close_pipe(pictures_);
    int status = 0;
    for (int pauses = 0; pauses < kMostEndPauses && process_ > 0; ++pauses)
        wait_for_end(status);
    const std::string words = words_.substr(0, words_.find('\n'));
    return Error{fmt::format("cannot make {}: ffmpeg {}", name_,
                             words.empty() ? otherwise : "says " + words)};
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
