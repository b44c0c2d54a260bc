#pragma once

// One thread for what may take time or touch the disk. The window's thread never waits for it: jobs
// go in and completions come out through lock-free queues.

#include "core/command_queue.h"

#include <deque>
#include <functional>
#include <semaphore>
#include <stop_token>
#include <thread>

namespace cambrian {

class BackgroundWorker {
public:
    // Runs on the window's thread, in deliver().
    using Completion = std::function<void()>;
    // Runs on the worker; shares nothing mutable with the window.
    using Job = std::function<Completion(std::stop_token)>;

    BackgroundWorker();
    // Finishes every job handed in; their tokens say stop, so that only short ones do their work.
    ~BackgroundWorker();
    BackgroundWorker(const BackgroundWorker&) = delete;
    BackgroundWorker& operator=(const BackgroundWorker&) = delete;

    // Jobs run one by one in order.
    void submit(Job job);
    // Runs the completions of finished jobs.
    void deliver();
    bool idle() const { return unfinished_ == 0; }

private:
    void run(const std::stop_token& stop);
    void send_waiting();

    std::deque<Job> waiting_;  // window's thread: not yet in the queue
    int unfinished_ = 0;       // window's thread: submitted, not delivered
    CommandQueue<Job, 64> jobs_;
    CommandQueue<Completion, 64> completions_;
    std::counting_semaphore<> available_{0};
    std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace cambrian
