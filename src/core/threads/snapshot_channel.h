#pragma once

// Passes the newest immutable value from one writer thread to one reader thread; neither ever
// waits. Older values that were not read are dropped. (In our library, std::atomic<std::shared_ptr>
// is not lock-free; the exchange of an index among three slots is.)

#include <array>
#include <atomic>
#include <memory>
#include <utility>

namespace cambrian {

template <class T>
class SnapshotChannel {
public:
    // May be called by the writer only.
    void publish(std::shared_ptr<const T> snapshot) {
        slots_[writer_] = std::move(snapshot);
        writer_ = middle_.exchange(writer_ | kFresh, std::memory_order_acq_rel) & kIndex;
    }
    // May be called by the reader only; null until something was published.
    const std::shared_ptr<const T>& latest() {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0) {
            reader_ = middle_.exchange(reader_, std::memory_order_acq_rel) & kIndex;
        }
        return slots_[reader_];
    }

private:
    static constexpr unsigned kFresh = 4;
    static constexpr unsigned kIndex = 3;
    std::array<std::shared_ptr<const T>, 3> slots_;
    unsigned writer_ = 0;
    unsigned reader_ = 1;
    std::atomic<unsigned> middle_ = 2;
};

}  // namespace cambrian
