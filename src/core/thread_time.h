#pragma once

#include <ctime>

namespace cambrian {

// CPU time of the calling thread, s, blind to how busy the machine is.
inline double thread_cpu_time() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Laps of it.
class ThreadTimer {
public:
    // s, since the last lap or the start.
    double lap() {
        const double before = last_;
        last_ = thread_cpu_time();
        return last_ - before;
    }

private:
    double last_ = thread_cpu_time();
};

}  // namespace cambrian
