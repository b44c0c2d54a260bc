#pragma once

// The inbox of a worker thread that sleeps while it has no work, and that a command interrupts. It
// holds any number of commands; its lock is only ever held for the time of a push or a pop.

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace cambrian {

template <class Command>
class WorkerInbox {
public:
    void send(Command command) {
        {
            const std::lock_guard lock(mutex_);
            commands_.push_back(std::move(command));
            interruption_.request_stop();
        }
        wake_.notify_one();
    }

    // May be called by the worker only. Takes out and applies all commands, also those that arrive
    // meanwhile; returns whether there were any.
    template <class Apply>
    bool drain(Apply apply) {
        bool any = false;
        while (std::optional<Command> command = pop()) {
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
            if (!commands_.empty()) return;
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
        wake_.wait(lock, std::move(stop), [this] { return !commands_.empty(); });
    }

private:
    std::optional<Command> pop() {
        const std::lock_guard lock(mutex_);
        if (commands_.empty()) return std::nullopt;
        std::optional<Command> first = std::move(commands_.front());
        commands_.pop_front();
        return first;
    }

    std::mutex mutex_;  // guards the members below
    std::condition_variable_any wake_;
    std::deque<Command> commands_;
    std::stop_source interruption_;
};

}  // namespace cambrian
