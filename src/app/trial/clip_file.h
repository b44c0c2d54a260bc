#pragma once

// A clip file, encoded by the installed ffmpeg from pictures sent through a pipe. It is written
// beside its target and renamed when complete; on failure it is deleted.

#include "core/files/pending_file.h"
#include "core/image.h"
#include "core/result.h"

#include <filesystem>
#include <memory>
#include <string>

namespace cambrian {

// Returns whether a name has an ending that ffmpeg writes here: ".mp4" or ".gif".
bool is_clip_name(const std::filesystem::path& path);

// Browsers show a picture of a GIF for 0.1 s if it asks for less than 0.02 s.
inline constexpr double kMostGifRate = 50.0;  // Hz
// Fails if the format of that name cannot show so many frames a second (Hz).
Status check_frame_rate(const std::filesystem::path& path, double frames_a_second);

class ClipFile {
public:
    // The name's ending determines the format, which must be able to show so many frames a second.
    // Fails if ffmpeg is not installed.
    static Result<std::unique_ptr<ClipFile>> open(const std::filesystem::path& path, int width,
                                                  int height, double frames_a_second);
    ~ClipFile();
    ClipFile(const ClipFile&) = delete;
    ClipFile& operator=(const ClipFile&) = delete;

    // Adds a picture of the clip's size. Waits until ffmpeg has read it.
    Status add(const Image& picture);
    // Fails if ffmpeg did or if it wrote nothing.
    Status finish();

private:
    ClipFile(PendingFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
    Status start(const std::vector<std::string>& arguments);
    void drain();
    bool wait_for_end(int& status);
    // Returns what ffmpeg said, or `otherwise`.
    Status failure(const char* otherwise = "failed");

    PendingFile file_;
    std::string name_;     // name of the target, for messages
    int process_ = -1;     // process id; -1 after it ended
    int pictures_ = -1;    // pipe to ffmpeg
    int complaints_ = -1;  // pipe from ffmpeg's standard error
    std::string words_;    // the first of what came from there
};

}  // namespace cambrian
