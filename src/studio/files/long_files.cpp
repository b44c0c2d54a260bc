#include "studio/files/long_files.h"

#include <algorithm>
#include <utility>

namespace cambrian {

void LongFiles::write(const std::filesystem::path& path, double length, FileWork work) {
    auto making = std::make_shared<Making>();
    making->path = path;
    making->length = length;
    making_.push_back(making);
    worker_.submit([this, making, work = std::move(work)](
                       const std::stop_token& stop) -> BackgroundWorker::Completion {
        const std::stop_callback forward(stop, [&making] { making->stop.request_stop(); });
        const std::stop_token asked = making->stop.get_token();
        Status status = asked.stop_requested() ? Error{"interrupted; nothing was written"}
                                               : work({.stop = asked, .time = &making->time});
        return [this, making, status = std::move(status)] {
            std::erase(making_, making);
            finished_.push_back({making->path, status, making->stop.stop_requested()});
        };
    });
}

void LongFiles::stop() {
    if (!making_.empty()) making_.front()->stop.request_stop();
}

FileProgress LongFiles::progress() const {
    if (making_.empty()) return {};
    const Making& making = *making_.front();
    const double share = making.length > 0.0 ? making.time / making.length : 0.0;
    return {making.path.filename().string(), std::clamp(share, 0.0, 1.0),
            making.stop.stop_requested()};
}

std::vector<FinishedFile> LongFiles::take_finished() {
    worker_.deliver();
    return std::exchange(finished_, {});
}

}  // namespace cambrian
