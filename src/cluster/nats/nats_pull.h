#pragma once

// Takes the messages of a JetStream consumer, by requests that the server answers ("pull consumer"
// of the documentation of NATS). The calls of libnats 3.4 for this write beyond the end of their
// list if answers to an earlier request arrive late.

#include "cluster/nats/nats_link.h"
#include "cluster/nats/nats_subscription.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

class NatsPull {
public:
    using Messages = std::vector<NatsHandle<natsMsg>>;

    // Returns null if the server cannot be asked.
    static std::unique_ptr<NatsPull> open(const NatsSessionPtr& session, const std::string& stream,
                                          const std::string& consumer);

    bool valid() const { return answers_->valid(); }
    // Returns 1 to `most` messages as soon as there is one, late answers to earlier calls among
    // them. Returns an empty list after `longest`, and nothing if the server cannot be asked or
    // refuses, for example because the consumer is gone. By one thread at a time.
    std::optional<Messages> fetch(std::size_t most, std::chrono::milliseconds longest);

private:
    using Clock = std::chrono::steady_clock;
    // Terms of a request.
    struct Wanted {
        std::size_t most = 1;
        bool wait = false;  // the server answers when there is a message, not at once
    };

    NatsPull(NatsSessionPtr session, std::shared_ptr<NatsSubscription> answers,
             std::string request_subject);
    void take_waiting(std::size_t most, Messages& messages) const;
    // Returns false if the server cannot be asked or refuses.
    bool request(const Wanted& wanted, Clock::time_point end, Messages& messages);
    bool send(const Wanted& wanted, Clock::time_point end, const std::string& answers);

    const NatsSessionPtr session_;
    const std::shared_ptr<NatsSubscription> answers_;
    const std::string request_subject_;
    std::uint64_t requests_ = 0;  // distinguishes the answers
};

}  // namespace cambrian
