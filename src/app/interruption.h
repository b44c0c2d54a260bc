#pragma once

#include <csignal>

namespace cambrian {

// While it lives, the first Ctrl+C (or request to terminate) only asks to finish; a second one ends
// the program at once. One at a time.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool requested() const;

private:
    struct sigaction interrupt_before_ {};
    struct sigaction terminate_before_ {};
};

}  // namespace cambrian
