#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace cambrian {

// While it lives, the first Ctrl+C (or request to terminate) only asks to stop; a second one ends
// the program at once. One at a time.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool requested() const;
    // Asks to stop soon after.
    std::stop_token token() const { return source_.get_token(); }

private:
    struct sigaction interrupt_before_ {};
    struct sigaction terminate_before_ {};
    std::stop_source source_;
    std::jthread watch_;  // last: uses the source
};

}  // namespace cambrian
