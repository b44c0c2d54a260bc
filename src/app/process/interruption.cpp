#include "app/process/interruption.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace cambrian {
namespace {

// The only variable that the signal handler writes.
volatile std::sig_atomic_t interrupted = 0;

constexpr auto kInterruptionPause = std::chrono::milliseconds(50);

void note_interruption(int /*signal*/) {
    interrupted = 1;
}

// A signal that was ignored before, for example by nohup, stays ignored.
void catch_signal(int signal, struct sigaction& before) {
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) return;
    struct sigaction once {};
    once.sa_handler = note_interruption;
    once.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    ::sigaction(signal, &once, nullptr);
}

}  // namespace

Interruption::Interruption() {
    interrupted = 0;
    catch_signal(SIGINT, interrupt_before_);
    catch_signal(SIGTERM, terminate_before_);
    catch_signal(SIGHUP, hang_up_before_);
    watch_ = std::jthread([this](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any woken;
        std::unique_lock lock(mutex);
        while (!stop.stop_requested() && !requested())
            woken.wait_for(lock, stop, kInterruptionPause, [] { return false; });
        if (requested()) source_.request_stop();
    });
}

Interruption::~Interruption() {
    ::sigaction(SIGINT, &interrupt_before_, nullptr);
    ::sigaction(SIGTERM, &terminate_before_, nullptr);
    ::sigaction(SIGHUP, &hang_up_before_, nullptr);
}

bool Interruption::requested() const {
    return interrupted != 0;
}

}  // namespace cambrian
