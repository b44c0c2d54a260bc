// MP4, by the installed ffmpeg, which reads the pictures from a pipe.

#include "core/files/pending_file.h"
#include "core/spawn_group.h"
#include "core/text/number_text.h"
#include "pictures/clips/clip_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
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

constexpr double kMostMp4Rate = 120.0;  // Hz

std::vector<std::string> arguments_of(const ClipPlan& plan,
                                      const std::filesystem::path& temporary) {
    return {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y",
            // The pictures that it gets.
            "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
            fmt::format("{}x{}", plan.width, plan.height), "-r", short_text(plan.frames_a_second),
            "-i", "pipe:0",
            // What it makes of them.
            "-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p",
            "-movflags", "+faststart", "-f", "mp4",
            // The prefix prevents a name from being read as a protocol or an option.
            "file:" + temporary.string()};
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

constexpr const char* kWithoutFfmpeg =
    "clips of MP4 are made by ffmpeg, which is not installed (Debian: apt install ffmpeg); GIF "
    "needs nothing more";

// Returns whether a program can be found as posix_spawnp() does it.
bool is_installed(const char* program) {
    const char* const path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    std::string_view left = path == nullptr ? "/bin:/usr/bin" : path;
    while (!left.empty()) {
        const std::string folder(left.substr(0, left.find(':')));
        left.remove_prefix(std::min(left.size(), folder.size() + 1));
        if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

Error spawn_failure(int code) {
    if (code == ENOENT) return Error{kWithoutFfmpeg};
    return Error{"ffmpeg cannot be started: " + std::generic_category().message(code)};
}

class Mp4Clip final : public ClipEncoder {
public:
    explicit Mp4Clip(PendingFile file) : file_(std::move(file)) {}
    ~Mp4Clip() override;
    Mp4Clip(const Mp4Clip&) = delete;
    Mp4Clip& operator=(const Mp4Clip&) = delete;

    Status begin(const ClipPlan& plan);
    // Waits until ffmpeg has read the picture.
    Status add(const Image& picture) override;
    // Fails if ffmpeg did or if it wrote nothing.
    Status finish() override;

private:
    void drain();
    bool wait_for_end(int& status);
    // Returns what ffmpeg said, or `otherwise`.
    Status failure(const char* otherwise = "failed");

    PendingFile file_;
    int process_ = -1;     // process id; -1 after it ended
    int pictures_ = -1;    // pipe to ffmpeg
    int complaints_ = -1;  // pipe from ffmpeg's standard error
    std::string words_;    // the first of what came from there
};

Status Mp4Clip::begin(const ClipPlan& plan) {
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
    const int code = spawn(arguments_of(plan, file_.path()), to[0], from[1], process_);
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
Status Mp4Clip::add(const Image& picture) {
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
void Mp4Clip::drain() {
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
bool Mp4Clip::wait_for_end(int& status) {
    pollfd messages{complaints_, POLLIN, 0};
    ::poll(&messages, 1, kEndPause);
    if (messages.revents != 0) drain();
    if (::waitpid(process_, &status, WNOHANG) == 0) return false;
    process_ = -1;
    drain();
    return true;
}

Status Mp4Clip::finish() {
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
Status Mp4Clip::failure(const char* otherwise) {
    close_pipe(pictures_);
    int status = 0;
    for (int pauses = 0; pauses < kMostEndPauses && process_ > 0; ++pauses)
        wait_for_end(status);
    const std::string words = words_.substr(0, words_.find('\n'));
    return Error{fmt::format("cannot make {}: ffmpeg {}", file_.target().string(),
                             words.empty() ? otherwise : "says " + words)};
}

Mp4Clip::~Mp4Clip() {
    close_pipe(pictures_);
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    close_pipe(complaints_);
}

Result<std::unique_ptr<ClipEncoder>> open_mp4(const ClipPlan& plan) {
    auto file = PendingFile::beside(plan.path);
    if (!file) return file.error();
    auto clip = std::make_unique<Mp4Clip>(*std::move(file));
    if (Status begun = clip->begin(plan); !begun) return begun.error();
    return std::unique_ptr<ClipEncoder>(std::move(clip));
}

std::string why_no_mp4() {
    return is_installed("ffmpeg") ? std::string() : kWithoutFfmpeg;
}

}  // namespace

ClipFormat mp4_format() {
    return {.ending = ".mp4",
            .label = "MP4",
            .usual_width = 1280,
            .usual_height = 720,
            .usual_rate = 30.0,
            .most_rate = kMostMp4Rate,
            .slowness = "displays show no more",
            .even_sides = true,
            .missing = why_no_mp4,
            .open = open_mp4};
}

}  // namespace cambrian
