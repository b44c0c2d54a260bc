#pragma once

// A message queue in this process that loses, delays, repeats and reorders messages; a seed decides
// which. Its times are 50 times shorter than a server's: ten seconds become a fifth of one.

#include "cluster/messages/work_queue.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace cambrian::test {

struct Faults {
    std::uint64_t seed = 1;
    double lost_delivery = 0.0;  // share of units whose delivery to a worker is lost
    double repeated_delivery = 0.0;
    double lost_result = 0.0;  // share of results that are lost
    double repeated_result = 0.0;
    bool reorders = false;
    std::chrono::milliseconds longest_delay{0};  // greatest delay of a result
    std::chrono::milliseconds patience{200};     // time until a unit is delivered again
    int most_deliveries = 5;
    std::size_t most_bytes = 1'000'000;  // of a message
    std::size_t most_units = 1'000;      // stored
};

class MemoryServer {
public:
    explicit MemoryServer(const Faults& faults = {});
    ~MemoryServer();

    std::unique_ptr<CoordinatorQueue> coordinator();
    std::unique_ptr<WorkerQueue> worker(std::string login);

    // While the server is down, nobody is connected; stored messages remain.
    void set_running(bool running);
    // Changes the results of workers on their way.
    void change_results(std::function<void(std::string& body)> change);

    // Adds messages without a sender; the login of a result is the message's.
    void inject_unit(const UnitMessage& unit);
    void inject_result(const UnitMessage& result);
    void inject_hello(const std::string& text, const std::string& login = "stranger");

    std::size_t stored_units() const;
    std::size_t deliveries() const;  // number of deliveries so far
    std::uint64_t run() const;       // number of the run begun last

    struct State;

private:
    std::shared_ptr<State> state_;
};

}  // namespace cambrian::test
