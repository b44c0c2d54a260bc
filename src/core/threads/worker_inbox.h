#pragma once

// The inbox of a worker thread that sleeps while it has no work, and that a command interrupts.
// There is one sending thread and one worker thread.

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
    // May be called by the sender only. Returns false if the inbox is full; the command is then
    // unchanged.
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

    // May be called by the worker only. Calls `apply` for every command sent so far; returns
    // whether there were any.
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

    // May be called by the worker only. Calls work(token) unless a command waits. The token
    // requests a stop when a command arrives or `stop` does.
    template <class Work>
    void work_until_command(const std::stop_token& stop, Work work) {
        std::stop_token token;
        {
            const std::lock_guard lock(mutex_);
            if (waiting_) return;
            interruption_ = std::stop_source();
            token = interruption_.get_token();
        }
        const std::stop_callback on_stop(stop, [this] {
            const std::lock_guard lock(mutex_);
            interruption_.request_stop();
        });
        work(token);
    }

    // May be called by the worker only. Sleeps until a command arrives or a stop is requested.
    void wait(std::stop_token stop) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, std::move(stop), [this] { return waiting_; });
    }

private:
    CommandQueue<Command, Capacity> queue_;
    // The mutex is used to sleep and to interrupt; the queue itself needs no lock.
    std::mutex mutex_;
    std::condition_variable_any wake_;
    bool waiting_ = false;           // guarded by mutex_
    std::stop_source interruption_;  // guarded by mutex_
};

}  // namespace cambrian
