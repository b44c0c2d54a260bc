#pragma once

// One connection to a server, which libnats makes again whenever it is lost, and what libnats's own
// threads say of it.

#include "cluster/connection/cluster_address.h"
#include "cluster/nats/nats_handles.h"
#include "core/result.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cambrian {

// What keeps a program from using a cluster.
struct LinkFailure {
    std::string message;
    bool lasting = false;  // waiting does not mend it: a mistake in the address, a file, the server
};

class NatsEvents;

class NatsSession {
public:
    // inbox: the subject under which answers to requests arrive. Takes up to a few seconds.
    static std::variant<std::shared_ptr<NatsSession>, LinkFailure> connect(
        const ClusterAddress& address, const std::string& inbox);
    ~NatsSession();
    NatsSession(const NatsSession&) = delete;
    NatsSession& operator=(const NatsSession&) = delete;

    natsConnection* connection() const { return connection_.get(); }
    jsCtx* jetstream() const { return jetstream_.get(); }
    const std::string& inbox() const { return inbox_; }

    bool connected() const;
    bool closed() const;               // libnats does not try any more
    std::uint64_t times_lost() const;  // the connection, since it was made
    // What went wrong, in the words for people; each once.
    std::vector<std::string> take_complaints();
    // The last refused permission since it was last asked for; a request that is not permitted is
    // otherwise merely never answered.
    std::string take_refusal();

    // False if it cannot be sent, for example while there is no connection.
    bool send(const std::string& subject, std::string_view body) const;

private:
    NatsSession() = default;

    std::string inbox_;
    std::unique_ptr<NatsEvents> events_;
    NatsHandle<natsConnection> connection_;
    NatsHandle<jsCtx> jetstream_;
};

// libnats's words for the last failure of the calling thread, on one line.
std::string last_nats_error();

// How long a request to the server may take, in ms. Requests fail at once if the connection is
// lost.
inline constexpr std::int64_t kNatsWait = 1000;

}  // namespace cambrian
