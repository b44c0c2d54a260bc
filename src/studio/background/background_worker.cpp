#include "studio/background/background_worker.h"

#include <utility>

namespace cambrian {

BackgroundWorker::BackgroundWorker()
    : thread_([this](const std::stop_token& stop) { run(stop); }) {}

BackgroundWorker::~BackgroundWorker() {
    while (!waiting_.empty()) {
        send_waiting();
        while (completions_.pop())
            --unfinished_;
        std::this_thread::yield();
    }
    thread_.request_stop();
    available_.release();
    // The worker may be waiting for room in the queue of completions.
    while (unfinished_ > 0) {
        while (completions_.pop())
            --unfinished_;
        std::this_thread::yield();
    }
}

void BackgroundWorker::submit(Job job) {
    waiting_.push_back(std::move(job));
    ++unfinished_;
    send_waiting();
}

void BackgroundWorker::send_waiting() {
    while (!waiting_.empty() && jobs_.push(std::move(waiting_.front()))) {
        waiting_.pop_front();
        available_.release();
    }
}

void BackgroundWorker::deliver() {
    send_waiting();
    while (auto completion = completions_.pop()) {
        --unfinished_;
        if (*completion) (*completion)();
    }
}

void BackgroundWorker::run(const std::stop_token& stop) {
    while (true) {
        available_.acquire();
        std::optional<Job> job = jobs_.pop();
        if (!job) return;  // the thread was woken by the stop request and no job is left
        Completion completion = (*job)(stop);
        // A failed push does not move from its argument.
        while (!completions_.push(std::move(completion)))  // NOLINT(bugprone-use-after-move)
            std::this_thread::yield();
    }
}

}  // namespace cambrian
