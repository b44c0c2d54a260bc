#pragma once

#include <ctime>

namespace cambrian {

// Returns the CPU time of the calling thread in s, on which other load has no influence.
inline double thread_cpu_time() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Measures laps of CPU time.
class ThreadTimer {
public:
    // Returns the CPU time, in s, since the last lap or the start.
    double lap() {
        const double before = last_;
        last_ = thread_cpu_time();
        return last_ - before;
    }

private:
    double last_ = thread_cpu_time();
};

}  // namespace cambrian
