#pragma once

// A clip as a file, made by the installed ffmpeg from pictures piped to it. It comes to be beside
// its target and takes its name when it is whole; otherwise nothing is left.

#include "core/image.h"
#include "core/pending_file.h"
#include "core/result.h"

#include <filesystem>
#include <memory>
#include <string>

namespace cambrian {

// Endings of names that ffmpeg is asked for: ".mp4" and ".gif".
bool is_clip_name(const std::filesystem::path& path);

class ClipFile {
public:
    // The format is that of the name's ending. Fails, saying so, without ffmpeg.
    static Result<std::unique_ptr<ClipFile>> open(const std::filesystem::path& path, int width,
                                                  int height, double frames_a_second);
    ~ClipFile();
    ClipFile(const ClipFile&) = delete;
    ClipFile& operator=(const ClipFile&) = delete;

    // Of the clip's size. Waits until ffmpeg has taken it.
    Status add(const Image& picture);
    Status finish();

private:
    ClipFile(PendingFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
    Status start(const std::vector<std::string>& arguments);
    Status failure();

    PendingFile file_;
    std::string name_;     // of the target, for messages
    int process_ = -1;     // -1 once it has ended
    int pictures_ = -1;    // the pipe to it
    int complaints_ = -1;  // the pipe from its standard error
};

}  // namespace cambrian
