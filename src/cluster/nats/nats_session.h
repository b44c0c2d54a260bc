#pragma once

// A connection to a server, which libnats restores whenever it is lost, and the events that
// libnats's threads report.

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

// A reason why a program cannot use a cluster.
struct LinkFailure {
    std::string message;
    bool lasting = false;  // permanent: an error in the address, a file or the server
};

class NatsEvents;

class NatsSession {
public:
    // Answers to requests arrive on subjects of this session alone, below `inbox_prefix`. Takes up
    // to a few seconds.
    static std::variant<std::shared_ptr<NatsSession>, LinkFailure> connect(
        const ClusterAddress& address, const std::string& inbox_prefix);
    ~NatsSession();
    NatsSession(const NatsSession&) = delete;
    NatsSession& operator=(const NatsSession&) = delete;

    natsConnection* connection() const { return connection_.get(); }
    jsCtx* jetstream() const { return jetstream_.get(); }
    const std::string& inbox() const { return inbox_; }

    bool connected() const;
    bool closed() const;               // libnats does not try to connect any more
    std::uint64_t times_lost() const;  // number of losses since the connection was made
    // Returns messages for users about problems, each once.
    std::vector<std::string> take_complaints();
    // Returns the last refused permission since the last call. A request without permission is
    // otherwise never answered.
    std::string take_refusal();

    // Returns false if it cannot be sent, for example while there is no connection.
    bool send(const std::string& subject, std::string_view body) const;

private:
    NatsSession() = default;

    std::string inbox_;
    std::unique_ptr<NatsEvents> events_;
    NatsHandle<natsConnection> connection_;
    NatsHandle<jsCtx> jetstream_;
};

// Returns libnats's message for the last failure of the calling thread, on one line.
std::string last_nats_error();

// The longest time, in ms, that a request to the server may take. Requests fail at once if the
// connection is lost.
inline constexpr std::int64_t kNatsWait = 1000;

}  // namespace cambrian
