#include "core/threads/thread_pool.h"

#include "core/assert.h"

#include <algorithm>
#include <atomic>
#include <exception>

namespace cambrian {

struct ThreadPool::Range {
    std::size_t count;
    const std::function<void(std::size_t, std::size_t)>& work;
    std::stop_token stop;
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> abandoned = false;
    std::mutex failure_mutex;
    std::exception_ptr failure;  // guarded by failure_mutex
};

ThreadPool::ThreadPool(std::size_t workers, ThreadPriority priority) : priority_(priority) {
    CAMBRIAN_ASSERT(workers >= 1, "a pool has at least the calling thread");
    threads_.reserve(workers - 1);
    for (std::size_t worker = 1; worker < workers; ++worker) {
        threads_.emplace_back([this, worker](const std::stop_token& stop) { serve(stop, worker); });
    }
}

ThreadPool::~ThreadPool() {
    for (std::jthread& thread : threads_)
        thread.request_stop();
    threads_.clear();
}

std::size_t ThreadPool::default_workers() {
    return std::max(1U, std::thread::hardware_concurrency());
}

void ThreadPool::take_part(Range& range, std::size_t worker) {
    while (!range.stop.stop_requested() && !range.abandoned.load(std::memory_order_relaxed)) {
        const std::size_t index = range.next.fetch_add(1, std::memory_order_relaxed);
        if (index >= range.count) return;
        try {
            range.work(index, worker);
        } catch (...) {
            const std::lock_guard lock(range.failure_mutex);
            if (!range.failure) range.failure = std::current_exception();
            range.abandoned = true;
        }
    }
    range.abandoned = true;
}

void ThreadPool::serve(const std::stop_token& stop, std::size_t worker) {
    take_priority(priority_);
    std::size_t seen_round = 0;
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [&] { return range_ != nullptr && round_ != seen_round; })) {
        seen_round = round_;
        Range* range = range_;
        ++busy_;
        lock.unlock();
        take_part(*range, worker);
        lock.lock();
        --busy_;
        done_.notify_all();
    }
}

bool ThreadPool::parallel_for(std::size_t count,
                              const std::function<void(std::size_t, std::size_t)>& work,
                              std::stop_token stop) {
    take_priority(priority_);
    Range range{
        .count = count, .work = work, .stop = std::move(stop), .failure_mutex = {}, .failure = {}};
    {
        const std::lock_guard lock(mutex_);
        CAMBRIAN_ASSERT(range_ == nullptr, "one range at a time");
        range_ = &range;
        ++round_;
    }
    wake_.notify_all();
    take_part(range, 0);
    {
        std::unique_lock lock(mutex_);
        range_ = nullptr;
        done_.wait(lock, [&] { return busy_ == 0; });
    }
    if (range.failure) std::rethrow_exception(range.failure);
    return !range.abandoned;
}

}  // namespace cambrian
