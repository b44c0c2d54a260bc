#pragma once

#include <atomic>
#include <stop_token>

namespace cambrian {

// Lets a caller stop one or several trials and read their progress.
struct TrialWatch {
    std::stop_token stop = {};
    std::atomic<double>* time = nullptr;  // s of the test phase, or another measure of progress

    void note(double seconds) const {
        if (time != nullptr) time->store(seconds);
    }
};

}  // namespace cambrian
