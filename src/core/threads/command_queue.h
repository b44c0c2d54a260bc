#pragma once

// A bounded lock-free queue from one producer thread to one consumer thread. A full queue rejects
// values; the producer keeps them and tries again later.

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>

namespace cambrian {

template <class T, std::size_t Capacity>
class CommandQueue {
public:
    // May be called by the producer only. Returns false if the queue is full; the value is then
    // unchanged.
    bool push(T&& value) {
        const std::size_t tail = tail_.load(std::memory_order_relaxed);
        const std::size_t next = (tail + 1) % kSlots;
        if (next == head_.load(std::memory_order_acquire)) return false;
        slots_[tail] = std::move(value);
        tail_.store(next, std::memory_order_release);
        return true;
    }
    // May be called by the consumer only.
    std::optional<T> pop() {
        const std::size_t head = head_.load(std::memory_order_relaxed);
        if (head == tail_.load(std::memory_order_acquire)) return std::nullopt;
        std::optional<T> value = std::move(slots_[head]);
        slots_[head] = T{};
        head_.store((head + 1) % kSlots, std::memory_order_release);
        return value;
    }

private:
    static constexpr std::size_t kSlots = Capacity + 1;
    std::array<T, kSlots> slots_{};
    std::atomic<std::size_t> head_ = 0;
    std::atomic<std::size_t> tail_ = 0;
};

}  // namespace cambrian
