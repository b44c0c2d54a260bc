#include "studio/memory.h"

#include <system_error>
#include <utility>

namespace cambrian {
namespace {

constexpr double kInterval = 2.0;  // s between two looks for changes

}  // namespace

std::filesystem::path Memory::last_experiment() const {
    if (folder_.empty()) return {};
    if (!kept_.experiment.empty()) return kept_.experiment;
    const std::filesystem::path own = own_experiment(folder_);
    std::error_code unknown;
    return std::filesystem::exists(own, unknown) ? own : std::filesystem::path();
}

bool Memory::due(double now) const {
    return now - kept_at_ > kInterval;
}

void Memory::keep(const Preferences& present, const Services& services) {
    kept_at_ = services.feedback.now();
    if (folder_.empty() || present == kept_) return;
    kept_ = present;
    write_in_background(services, [folder = folder_, present, &kinds = services.kinds] {
        return remember(folder, present, kinds);
    });
}

}  // namespace cambrian
