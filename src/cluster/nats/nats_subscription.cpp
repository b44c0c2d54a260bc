#include "cluster/nats/nats_subscription.h"

namespace cambrian {

std::shared_ptr<NatsSubscription> NatsSubscription::plain(
    const std::shared_ptr<NatsSession>& session, const std::string& subject, int most_messages) {
    natsSubscription* made = nullptr;
    const natsStatus status =
        natsConnection_SubscribeSync(&made, session->connection(), subject.c_str());
    if (status != NATS_OK) return nullptr;
    natsSubscription_SetPendingLimits(made, most_messages, -1);
    return std::make_shared<NatsSubscription>(session, made);
}

NatsHandle<natsMsg> NatsSubscription::next(std::chrono::milliseconds longest) const {
    natsMsg* message = nullptr;
    natsSubscription_NextMsg(&message, subscription_.get(), longest.count());
    return NatsHandle<natsMsg>(message);
}

std::string_view body_of(const natsMsg& message) {
    return {natsMsg_GetData(&message), static_cast<std::size_t>(natsMsg_GetDataLength(&message))};
}

std::string_view subject_of(const natsMsg& message) {
    return natsMsg_GetSubject(&message);
}

}  // namespace cambrian
