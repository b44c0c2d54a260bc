#pragma once

// A fixed set of workers that call one function for every index of a range. Workers take the next
// index from a common counter, so the order is not fixed. The function must therefore write only
// data of its index or its worker.

#include "core/threads/thread_priority.h"

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace cambrian {

class ThreadPool {
public:
    // `workers` must be at least 1. The calling thread takes part in parallel_for(), so workers - 1
    // threads start; the calling thread gets their priority, too.
    explicit ThreadPool(std::size_t workers, ThreadPriority priority = ThreadPriority::kNormal);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    std::size_t workers() const { return threads_.size() + 1; }

    // Returns one thread per core, at least one.
    static std::size_t default_workers();

    // Calls work(index, worker) for each index of 0 .. count-1, with worker in 0 .. workers()-1,
    // and returns when all calls have ended. After a stop request no further call begins, and it
    // returns false. The first exception thrown by `work` ends the range and is thrown here.
    bool parallel_for(std::size_t count,
                      const std::function<void(std::size_t index, std::size_t worker)>& work,
                      std::stop_token stop = {});

private:
    struct Range;
    void serve(const std::stop_token& stop, std::size_t worker);
    static void take_part(Range& range, std::size_t worker);

    const ThreadPriority priority_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::condition_variable_any done_;
    Range* range_ = nullptr;  // guarded by mutex_
    std::size_t round_ = 0;   // guarded by mutex_; counts parallel_for calls
    std::size_t busy_ = 0;    // guarded by mutex_; workers inside range_
    std::vector<std::jthread> threads_;
};

}  // namespace cambrian
