#pragma once

// A message queue in this process, which loses, delays, repeats and reorders messages on command,
// as decided by a seed. Times are short: what takes a server ten seconds takes it a fifth of one.

#include "cluster/messages/work_queue.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace cambrian::test {

struct Faults {
    std::uint64_t seed = 1;
    double lost_delivery = 0.0;  // share of units sent to a worker that does not get them
    double repeated_delivery = 0.0;
    double lost_result = 0.0;  // share of results that the coordinator never gets
    double repeated_result = 0.0;
    bool reorders = false;
    std::chrono::milliseconds longest_delay{0};  // of a result
    std::chrono::milliseconds patience{200};     // until a unit is delivered again
    int most_deliveries = 5;
    std::size_t most_bytes = 1'000'000;  // of a message
    std::size_t most_units = 1'000;      // stored
};

class MemoryServer {
public:
    explicit MemoryServer(const Faults& faults = {});
    ~MemoryServer();

    std::unique_ptr<CoordinatorQueue> coordinator();
    std::unique_ptr<WorkerQueue> worker();

    // While it is down nobody is connected; what is stored stays.
    void set_running(bool running);
    // What a worker's result becomes on its way.
    void change_results(std::function<void(std::string& body)> change);

    // Messages from nobody in particular.
    void inject_unit(const UnitMessage& unit);
    void inject_result(const UnitMessage& result);
    void inject_hello(const std::string& text);

    std::size_t stored_units() const;
    std::size_t deliveries() const;  // so far
    std::uint64_t run() const;       // the last one begun

    struct State;

private:
    std::shared_ptr<State> state_;
};

}  // namespace cambrian::test
