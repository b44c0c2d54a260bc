#include "comparison/statistics.h"

#include "core/random.h"

#include <algorithm>
#include <cstddef>

namespace cambrian {
namespace {

constexpr int kSamples = 10'000;
constexpr double kTail = 0.05;

// Returns twice the midrank of every value. Twice a midrank is an integer.
std::vector<std::size_t> doubled_ranks(const std::vector<double>& values) {
    std::vector<std::size_t> ranks;
    ranks.reserve(values.size());
    for (const double value : values) {
        std::size_t below = 0;
        std::size_t equal = 0;
        for (const double other : values) {
            below += other < value ? 1 : 0;
            equal += other == value ? 1 : 0;
        }
        ranks.push_back(2 * below + equal + 1);
    }
    return ranks;
}

}  // namespace

Interval median_interval(const std::vector<double>& values) {
    RandomStream stream(stream_seed({values.size(), 90}));
    std::vector<double> medians;
    std::vector<double> sample(values.size());
    for (int i = 0; i < kSamples; ++i) {
        for (double& value : sample)
            value = values[stream.below(values.size())];
        medians.push_back(median(sample));
    }
    std::sort(medians.begin(), medians.end());
    const auto cut = static_cast<std::size_t>(kTail * kSamples);
    return {medians[cut], medians[kSamples - 1 - cut]};
}

RankTest mann_whitney(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> all = a;
    all.insert(all.end(), b.begin(), b.end());
    const std::vector<std::size_t> ranks = doubled_ranks(all);
    std::size_t observed = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        observed += ranks[i];
    std::size_t largest = 0;
    for (const std::size_t rank : ranks)
        largest += rank;
    // ways[k][s] counts the ways to choose k values whose doubled ranks sum to s.
    std::vector<std::vector<double>> ways(a.size() + 1, std::vector<double>(largest + 1, 0.0));
    ways[0][0] = 1.0;
    for (const std::size_t rank : ranks) {
        for (std::size_t k = a.size(); k > 0; --k) {
            for (std::size_t sum = largest; sum >= rank; --sum)
                ways[k][sum] += ways[k - 1][sum - rank];
        }
    }
    double total = 0.0;
    double extreme = 0.0;
    for (std::size_t sum = 0; sum <= largest; ++sum) {
        total += ways[a.size()][sum];
        if (sum >= observed) extreme += ways[a.size()][sum];
    }
    const auto n = static_cast<double>(a.size());
    const double u = 0.5 * static_cast<double>(observed) - 0.5 * n * (n + 1.0);
    return {extreme / total, u / (n * static_cast<double>(b.size()))};
}

double two_sided(const std::vector<double>& a, const std::vector<double>& b) {
    return std::min(1.0, 2.0 * std::min(mann_whitney(a, b).p, mann_whitney(b, a).p));
}

}  // namespace cambrian
