#include "pictures/clips/clip_file.h"

#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostWaiting = 3;  // pictures

}  // namespace

Result<std::unique_ptr<ClipFile>> ClipFile::open(const ClipFormat& format, const ClipPlan& plan) {
    auto encoder = format.open(plan);
    if (!encoder) return encoder.error();
    std::unique_ptr<ClipFile> clip(new ClipFile(*std::move(encoder)));
    clip->thread_ = std::thread([&file = *clip] { file.run(); });
    return clip;
}

void ClipFile::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return ended_ || !pictures_.empty(); });
        if (pictures_.empty()) return;
        const Image picture = std::move(pictures_.front());
        pictures_.pop_front();
        lock.unlock();
        Status added = encoder_->add(picture);
        lock.lock();
        if (!added) {
            status_ = std::move(added);
            ended_ = true;
            pictures_.clear();
        }
        changed_.notify_all();
    }
}

Status ClipFile::add(Image picture) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ended_ || pictures_.size() < kMostWaiting; });
    if (ended_) return status_;
    pictures_.push_back(std::move(picture));
    changed_.notify_all();
    return {};
}

void ClipFile::end() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
}

Status ClipFile::finish() {
    end();
    return status_ ? encoder_->finish() : status_;
}

ClipFile::~ClipFile() {
    {
        const std::lock_guard lock(mutex_);
        pictures_.clear();
    }
    end();
}

}  // namespace cambrian
