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

class ClipFile {
public:
    // The name's ending determines the format. Fails if ffmpeg is not installed.
    static Result<std::unique_ptr<ClipFile>> open(const std::filesystem::path& path, int width,
                                                  int height, double frames_a_second);
    ~ClipFile();
    ClipFile(const ClipFile&) = delete;
    ClipFile& operator=(const ClipFile&) = delete;

    // Adds a picture of the clip's size. Waits until ffmpeg has read it.
    Status add(const Image& picture);
    Status finish();

private:
    ClipFile(PendingFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
    Status start(const std::vector<std::string>& arguments);
    Status failure();

    PendingFile file_;
    std::string name_;     // name of the target, for messages
    int process_ = -1;     // process id; -1 after it ended
    int pictures_ = -1;    // pipe to ffmpeg
    int complaints_ = -1;  // pipe from ffmpeg's standard error
};

}  // namespace cambrian
