#pragma once

// Maintains a connection to a cluster on a separate thread: it connects, prepares streams and
// subscriptions, and repeats both after each loss.

#include "cluster/connection/cluster_address.h"
#include "cluster/connection/complaints.h"
#include "cluster/nats/nats_session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace cambrian {

using NatsSessionPtr = std::shared_ptr<NatsSession>;

class NatsLink {
public:
    // Prepares streams and subscriptions on a new connection.
    using Prepare = std::function<std::optional<LinkFailure>(const NatsSessionPtr&)>;
    using Job = std::function<void(NatsSession&)>;

    NatsLink(ClusterAddress address, std::string inbox, Prepare prepare);
    ~NatsLink();
    NatsLink(const NatsLink&) = delete;
    NatsLink& operator=(const NatsLink&) = delete;

    // Makes the first attempt on the calling thread. Fails for permanent errors; for an unreachable
    // server it adds a complaint and tries again.
    Status open();

    // The prepared connection; null while there is none.
    NatsSessionPtr ready() const;
    // Prepares again after the pause, because streams vanished from the server or others are
    // needed.
    void renew(std::chrono::milliseconds pause);
    // The link's thread runs the job as soon as the connection is ready. Jobs are dropped if too
    // many wait.
    void later(Job job);
    // Adds a message for users; each is reported once.
    void complain(const std::string& words);
    std::vector<std::string> take_complaints();
    // Waits until the state changes, for at most `longest`.
    void wait(std::chrono::milliseconds longest) const;

private:
    std::optional<LinkFailure> attempt();
    void keep(const std::stop_token& stop);
    std::chrono::milliseconds pause_after(const LinkFailure& failure);
    void do_jobs(NatsSession& session);
    bool is_ready_locked() const;
    bool is_too_early() const;

    const ClusterAddress address_;
    const std::string inbox_;
    const Prepare prepare_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    NatsSessionPtr session_;  // set after the first connection
    bool prepared_ = false;
    bool renewed_ = false;      // must be prepared again at once
    std::uint64_t losses_ = 0;  // of the session when it was last prepared
    std::chrono::steady_clock::time_point not_before_{};
    std::deque<Job> jobs_;
    Complaints complaints_;
    int failures_ = 0;     // attempts since the last success; used by the link's thread
    std::jthread thread_;  // last: uses everything above
};

}  // namespace cambrian
