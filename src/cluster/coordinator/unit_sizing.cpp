#include "cluster/coordinator/unit_sizing.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kMemory = 200.0;  // number of creatures over which old measurements fade
constexpr double kLeastSeconds = 0.01;
constexpr double kMostSeconds = 2.0;
constexpr double kBusyPace = 2.0;  // of own cores that have much else to do
constexpr double kRounds = 4.0;    // units per core if all were as long as the next

double median_work(std::span<const EvaluationRequest> requests, double fallback) {
    std::vector<double> known;
    for (const EvaluationRequest& request : requests) {
        if (request.expected_work > 0) known.push_back(static_cast<double>(request.expected_work));
    }
    if (known.empty()) return fallback;
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::nth_element(known.begin(), middle, known.end());
    return *middle;
}

}  // namespace

std::vector<double> CostModel::seconds_of(std::span<const EvaluationRequest> requests) const {
    const double unknown = median_work(requests, work_ / creatures_);
    std::vector<double> seconds;
    seconds.reserve(requests.size());
    for (const EvaluationRequest& request : requests) {
        const double work =
            request.expected_work > 0 ? static_cast<double>(request.expected_work) : unknown;
        seconds.push_back(work * seconds_ / work_);
    }
    return seconds;
}

void CostModel::learn(std::size_t creatures, std::uint64_t work, double seconds) {
    if (creatures == 0 || work == 0 || !(seconds > 0.0)) return;
    const auto count = static_cast<double>(creatures);
    const double kept = 1.0 / (1.0 + count / kMemory);
    creatures_ = kept * creatures_ + count;
    work_ = kept * work_ + static_cast<double>(work);
    seconds_ = kept * seconds_ + seconds;
}

double unit_seconds(LeftWork left, const Cores& cores) {
    const auto own = static_cast<double>(cores.own);
    const auto remote = static_cast<double>(cores.remote);
    const double guided =
        std::clamp(left.open / (own + remote) / kRounds, kLeastSeconds, kMostSeconds);
    // Runs at once share the own cores, so one creature on these may take as long as all others.
    if (left.own_pace > kBusyPace) left = {.open = left.open};
    // With this much, (sent + even) / remote + latency = (open - even) own_pace / own.
    const double even =
        (left.open * left.own_pace * remote - left.sent * own - left.latency * own * remote) /
        (own + left.own_pace * remote);
    return std::min(guided, even);
}

double unit_deadline(double seconds) {
    constexpr double kFactor = 20.0;
    constexpr double kLeast = 60.0;  // s
    return std::max(kLeast, kFactor * seconds);
}

double useful_cores_of_batch(double core_seconds, double seconds, const Cores& cores) {
    constexpr double kLeastOverhead = 1e-3;  // s
    const double ideal = core_seconds / static_cast<double>(cores.all());
    return useful_cores(core_seconds, std::max(kLeastOverhead, seconds - ideal));
}

}  // namespace cambrian
