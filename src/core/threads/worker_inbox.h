#pragma once

// The commands of a thread that sleeps while it has nothing to do and breaks off what it does when
// a command comes. One user thread, one worker thread.

#include "core/threads/command_queue.h"

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace cambrian {

template <class Command, std::size_t Capacity>
class WorkerInbox {
public:
    // User only. False if full; the command is then untouched.
    bool send(Command&& command) {
        if (!queue_.push(std::move(command))) return false;
        {
            const std::lock_guard lock(mutex_);
            waiting_ = true;
            interruption_.request_stop();
        }
        wake_.notify_one();
        return true;
    }

    // Worker only. Calls apply for every command sent so far; whether there were any.
    template <class Apply>
    bool drain(Apply apply) {
        {
            const std::lock_guard lock(mutex_);
            waiting_ = false;
        }
        bool any = false;
        while (std::optional<Command> command = queue_.pop()) {
            apply(*std::move(command));
            any = true;
        }
        return any;
    }

    // Worker only. Calls work(token) unless a command waits; the token says stop once one does or
    // `stop` does.
    template <class Work>
    void work_until_command(const std::stop_token& stop, Work work) {
        std::stop_token interrupted;
        {
            const std::lock_guard lock(mutex_);
            if (waiting_) return;
            interruption_ = std::stop_source();
            interrupted = interruption_.get_token();
        }
        const std::stop_callback on_stop(stop, [this] {
            const std::lock_guard lock(mutex_);
            interruption_.request_stop();
        });
        work(interrupted);
    }

    // Worker only. Sleeps until a command waits or a stop is asked for.
    void wait(std::stop_token stop) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, std::move(stop), [this] { return waiting_; });
    }

private:
    CommandQueue<Command, Capacity> queue_;
    // Only to sleep and to interrupt; the queue itself needs no lock.
    std::mutex mutex_;
    std::condition_variable_any wake_;
    bool waiting_ = false;           // guarded by mutex_
    std::stop_source interruption_;  // guarded by mutex_
};

}  // namespace cambrian
