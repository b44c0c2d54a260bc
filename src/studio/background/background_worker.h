#pragma once

// One thread for tasks that may take long or use the disk. The window's thread never waits for it.

#include "core/threads/worker_inbox.h"

#include <functional>
#include <stop_token>
#include <thread>
#include <utility>

namespace cambrian {

// Destruction finishes every submitted job. Their stop tokens are set, so that long jobs end early.
class BackgroundWorker {
public:
    // A completion runs on the window's thread, in deliver().
    using Completion = std::function<void()>;
    // A job runs on the worker's thread and shares no mutable data with the window.
    using Job = std::function<Completion(std::stop_token)>;

    // Jobs run one at a time, in the order of submission.
    void submit(Job job) {
        ++unfinished_;
        jobs_.send(std::move(job));
    }
    // Runs the completions of finished jobs.
    void deliver() {
        completions_.drain([this](const Completion& completion) {
            --unfinished_;
            if (completion) completion();
        });
    }
    bool idle() const { return unfinished_ == 0; }

private:
    void run(const std::stop_token& stop) {
        bool last = false;
        while (!last) {
            last = stop.stop_requested();
            jobs_.drain([&](const Job& job) { completions_.send(job(stop)); });
            jobs_.wait(stop);
        }
    }

    int unfinished_ = 0;  // window's thread only; submitted and not yet delivered
    WorkerInbox<Job> jobs_;
    WorkerInbox<Completion> completions_;
    // Last member, so that it is joined before the others are destroyed.
    std::jthread thread_{[this](const std::stop_token& stop) { run(stop); }};
};

}  // namespace cambrian
