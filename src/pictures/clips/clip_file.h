#pragma once

// A clip that is encoded on a thread of its own while the next pictures are drawn.

#include "pictures/clips/clip_format.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace cambrian {

class ClipFile {
public:
    // Fails if the format cannot be written here.
    static Result<std::unique_ptr<ClipFile>> open(const ClipFormat& format, const ClipPlan& plan);
    // Waits for the thread; a clip that is not finished leaves nothing.
    ~ClipFile();
    ClipFile(const ClipFile&) = delete;
    ClipFile& operator=(const ClipFile&) = delete;

    // Hands over a picture of the clip's size; waits while many others are not encoded yet. Fails
    // if one before could not be.
    Status add(Image picture);
    // Waits for the last picture and puts the file in its place.
    Status finish();

private:
    explicit ClipFile(std::unique_ptr<ClipEncoder> encoder) : encoder_(std::move(encoder)) {}
    void run();
    void end();

    std::unique_ptr<ClipEncoder> encoder_;  // of the thread, until it ended
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Image> pictures_;  // not encoded yet
    bool ended_ = false;          // no picture follows
    Status status_;
    std::thread thread_;
};

}  // namespace cambrian
