#pragma once

// Measures wall time for display and benchmarks, never for decisions that change a result.

#include <chrono>

namespace cambrian {

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    void restart() { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace cambrian
