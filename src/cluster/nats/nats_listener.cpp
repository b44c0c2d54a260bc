// Hears who is in a cluster, over NATS.
#include "cluster/connection/cluster_connection.h"
#include "cluster/nats/nats_session.h"
#include "cluster/nats/nats_subjects.h"
#include "cluster/nats/nats_subscription.h"

#include <chrono>
#include <variant>

namespace cambrian {

Result<std::vector<std::string>> listen_to_cluster(const ClusterAddress& address,
                                                   std::chrono::milliseconds time) {
    using namespace std::chrono_literals;
    const NatsSubjects subjects(address.name);
    auto connected = NatsSession::connect(address, subjects.coordinator_inbox());
    if (const auto* failure = std::get_if<LinkFailure>(&connected)) return Error{failure->message};
    const auto session = std::get<NatsSessionPtr>(connected);
    const auto hellos = NatsSubscription::plain(session, subjects.all_hellos(), kMostHellosWaiting);
    if (!hellos) return Error{last_nats_error()};
    std::vector<std::string> texts;
    const auto end = std::chrono::steady_clock::now() + time;
    for (auto now = std::chrono::steady_clock::now(); now < end;
         now = std::chrono::steady_clock::now()) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - now) + 1ms;
        const auto message = hellos->next(left);
        if (message && body_of(*message).size() <= kMostHelloBytes)
            texts.emplace_back(body_of(*message));
    }
    if (const std::string refusal = session->take_refusal(); !refusal.empty())
        return Error{refusal};
    return texts;
}

}  // namespace cambrian
