#pragma once

// The sum of a quantity over the last minute of wall time. It is for display only, never for
// decisions that change a result.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace cambrian {

class RecentSum {
public:
    static constexpr int kSeconds = 60;

    // `now` is in s of any clock; all calls must use the same one. If it runs back, the sum of the
    // time gone over again may be too small.
    void add(double amount, double now) {
        Bucket& bucket = buckets_[place(second(now))];
        if (bucket.second != second(now)) bucket = {second(now), 0.0};
        bucket.amount += amount;
        first_ = std::min(first_, now);
    }

    // Returns the sum over the last `seconds` (1 to kSeconds), the present one included.
    double sum(double now, int seconds = kSeconds) const {
        double total = 0.0;
        for (const Bucket& bucket : buckets_) {
            if (bucket.second > second(now) - seconds && bucket.second <= second(now))
                total += bucket.amount;
        }
        return total;
    }

    // Returns the rate per second over the last `seconds`, or since the first add() if that is
    // less.
    double rate(double now, int seconds) const {
        const double whole = static_cast<double>(seconds - 1) + (now - std::floor(now));
        return sum(now, seconds) / std::clamp(now - first_, 1.0, std::max(1.0, whole));
    }

private:
    struct Bucket {
        std::int64_t second = std::numeric_limits<std::int64_t>::min();  // none yet
        double amount = 0.0;
    };

    static std::int64_t second(double now) { return static_cast<std::int64_t>(std::floor(now)); }
    static std::size_t place(std::int64_t second) {
        const std::int64_t rest = second % kSeconds;
        return static_cast<std::size_t>(rest < 0 ? rest + kSeconds : rest);
    }

    std::array<Bucket, kSeconds> buckets_;
    double first_ = 1e300;  // s; time of the first add(), or a value later than any
};

}  // namespace cambrian
