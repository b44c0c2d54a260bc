#pragma once

// Messages of a subject, which the calling thread takes one by one.

#include "cluster/nats/nats_handles.h"
#include "cluster/nats/nats_session.h"

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr int kMostHellosWaiting = 4096;  // messages not yet polled

class NatsSubscription {
public:
    // Keeps at most `most_messages` messages that were not taken, and drops later ones.
    static std::shared_ptr<NatsSubscription> plain(const std::shared_ptr<NatsSession>& session,
                                                   const std::string& subject, int most_messages);
    // Takes over a subscription made with JetStream's calls.
    NatsSubscription(std::shared_ptr<NatsSession> session, natsSubscription* subscription)
        : session_(std::move(session)), subscription_(subscription) {}
    ~NatsSubscription() { natsSubscription_Unsubscribe(subscription_.get()); }
    NatsSubscription(const NatsSubscription&) = delete;
    NatsSubscription& operator=(const NatsSubscription&) = delete;

    bool valid() const { return natsSubscription_IsValid(subscription_.get()); }
    // Returns null if no message arrives in time.
    NatsHandle<natsMsg> next(std::chrono::milliseconds longest) const;

private:
    std::shared_ptr<NatsSession> session_;  // outlives the subscription
    NatsHandle<natsSubscription> subscription_;
};

std::string_view body_of(const natsMsg& message);
std::string_view subject_of(const natsMsg& message);

}  // namespace cambrian
