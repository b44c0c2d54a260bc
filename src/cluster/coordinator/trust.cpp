#include "cluster/coordinator/trust.h"

#include "core/random.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr double kCertainChecks = 16.0;

}  // namespace

bool Trust::draw_check(std::uint64_t worker, std::uint32_t generation, std::uint32_t slot,
                       double least) {
    Record& record = workers_[worker];
    ++record.results;
    const double chance = std::max(least, kCertainChecks / static_cast<double>(record.results));
    RandomStream random(stream_seed({secret_, worker, generation, slot}));
    return random.chance(chance);
}

void Trust::refuse(std::uint64_t worker, std::string reason) {
    if (!refused(worker)) refusals_.push_back({worker, std::move(reason)});
}

bool Trust::refused(std::uint64_t worker) const {
    return std::any_of(refusals_.begin(), refusals_.end(),
                       [&](const Refusal& each) { return each.worker == worker; });
}

std::uint64_t Trust::checks_passed(std::uint64_t worker) const {
    const auto found = workers_.find(worker);
    return found == workers_.end() ? 0 : found->second.passed;
}

std::string Trust::refusal(std::uint64_t worker) const {
    for (const Refusal& each : refusals_) {
        if (each.worker == worker) return each.reason;
    }
    return {};
}

std::vector<Refusal> Trust::refusals() const {
    return refusals_;
}

}  // namespace cambrian
