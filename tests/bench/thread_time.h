#pragma once

#include <ctime>

namespace cambrian::bench {

// Laps of CPU time of the calling thread, blind to how busy the machine is.
class ThreadTimer {
public:
    // s, since the last lap or the start.
    double lap() {
        const double before = last_;
        last_ = now();
        return last_ - before;
    }

private:
    static double now() {
        timespec time{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double last_ = now();
};

}  // namespace cambrian::bench
