#include "studio/background/services.h"

#include <utility>

namespace cambrian {

void write_in_background(const Services& services, std::function<Status()> write) {
    services.worker.submit(
        [write = std::move(write), &feedback = services.feedback](const std::stop_token&) {
            return [&feedback, status = write()] { feedback.report(status); };
        });
}

}  // namespace cambrian
