#pragma once

// One thread for tasks that may take long or use the disk. The window's thread never waits for it:
// jobs and their completions pass through lock-free queues.

#include "core/threads/command_queue.h"

#include <deque>
#include <functional>
#include <semaphore>
#include <stop_token>
#include <thread>

namespace cambrian {

class BackgroundWorker {
public:
    // A completion runs on the window's thread, in deliver().
    using Completion = std::function<void()>;
    // A job runs on the worker's thread and shares no mutable data with the window.
    using Job = std::function<Completion(std::stop_token)>;

    BackgroundWorker();
    // The destructor finishes every submitted job. Their stop tokens are set, so that long jobs end
    // early.
    ~BackgroundWorker();
    BackgroundWorker(const BackgroundWorker&) = delete;
    BackgroundWorker& operator=(const BackgroundWorker&) = delete;

    // Jobs run one at a time, in the order of submission.
    void submit(Job job);
    // Runs the completions of finished jobs.
    void deliver();
    bool idle() const { return unfinished_ == 0; }

private:
    void run(const std::stop_token& stop);
    void send_waiting();

    std::deque<Job> waiting_;  // window's thread only; jobs that did not fit into the queue
    int unfinished_ = 0;       // window's thread only; submitted and not yet delivered
    CommandQueue<Job, 64> jobs_;
    CommandQueue<Completion, 64> completions_;
    std::counting_semaphore<> available_{0};
    std::jthread thread_;  // last member, so that it is joined before the others are destroyed
};

}  // namespace cambrian
