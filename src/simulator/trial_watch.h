#pragma once

#include <atomic>
#include <stop_token>

namespace cambrian {

// Somebody who waits for a trial, or for several: may ask them to stop and sees how far they are.
struct TrialWatch {
    std::stop_token stop = {};
    std::atomic<double>* time = nullptr;  // s of the test phase, or what else is counted

    void note(double seconds) const {
        if (time != nullptr) time->store(seconds);
    }
};

}  // namespace cambrian
