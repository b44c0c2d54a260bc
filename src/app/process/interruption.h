#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace cambrian {

// During its lifetime, the first Ctrl+C (or termination request, or hang-up of the terminal)
// requests a stop; a second one ends the program at once. Signals that were ignored when the
// program started stay ignored. Only one object may exist at a time.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool requested() const;
    // A stop is requested shortly after the signal.
    std::stop_token token() const { return source_.get_token(); }

private:
    struct sigaction interrupt_before_ {};
    struct sigaction terminate_before_ {};
    struct sigaction hang_up_before_ {};
    std::stop_source source_;
    std::jthread watch_;  // last member, since it uses the source
};

}  // namespace cambrian
