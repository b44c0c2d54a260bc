#include "app/interruption.h"

namespace cambrian {
namespace {

// The one thing a signal handler may write.
volatile std::sig_atomic_t interrupted = 0;

void note_interruption(int /*signal*/) {
    interrupted = 1;
}

}  // namespace

Interruption::Interruption() {
    interrupted = 0;
    struct sigaction once {};
    once.sa_handler = note_interruption;
    once.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    ::sigaction(SIGINT, &once, &interrupt_before_);
    ::sigaction(SIGTERM, &once, &terminate_before_);
}

Interruption::~Interruption() {
    ::sigaction(SIGINT, &interrupt_before_, nullptr);
    ::sigaction(SIGTERM, &terminate_before_, nullptr);
}

bool Interruption::requested() const {
    return interrupted != 0;
}

}  // namespace cambrian
