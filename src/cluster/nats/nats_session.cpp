#include "cluster/nats/nats_session.h"

#include "cluster/connection/complaints.h"
#include "cluster/connection/credentials.h"
#include "cluster/messages/text_for_people.h"
#include "core/files/file_io.h"
#include "core/random_id.h"
#include "persist/text/digest_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <netdb.h>
#include <string_view>

namespace cambrian {
namespace {

constexpr std::int64_t kConnectWait = 2000;       // ms
constexpr int kConnectTries = 3;                  // while a server refuses the credentials
constexpr std::int64_t kPingInterval = 2000;      // ms
constexpr int kPingsUnanswered = 2;               // afterwards the connection counts as lost
constexpr std::int64_t kWriteWait = 2000;         // ms
constexpr std::int64_t kFirstReconnect = 100;     // ms
constexpr std::int64_t kLongestReconnect = 1500;  // ms
constexpr int kMostReconnects = 2'000'000'000;    // practically unlimited
constexpr std::chrono::seconds kLongestGoodbye{5};
constexpr std::size_t kLongestWords = 300;  // bytes
constexpr std::size_t kMostAuthorityBytes = 4'000'000;

// The pause between two attempts to reconnect. It grows with each attempt and differs between
// programs.
std::int64_t reconnect_pause(natsConnection* /*connection*/, int attempts, void* /*closure*/) {
    std::int64_t pause = kFirstReconnect;
    for (int i = 0; i < attempts && pause < kLongestReconnect; ++i)
        pause *= 2;
    pause = std::min(pause, kLongestReconnect);
    return pause / 2 + nats_NowInNanoSeconds() % (pause / 2);
}

std::string host_of(std::string_view server) {
    server.remove_prefix(server.find("://") + 3);
    server = server.substr(0, server.rfind(':'));
    if (server.starts_with('[')) server = server.substr(1, server.size() - 2);
    return std::string(server);
}

// False only if there is no such host; a name that cannot be looked up now may be known later.
bool is_known_host(const std::string& host) {
    addrinfo* found = nullptr;
    const int failure = ::getaddrinfo(host.c_str(), nullptr, nullptr, &found);
    if (failure == 0) ::freeaddrinfo(found);
    return failure == 0 || failure == EAI_AGAIN;
}

// Returns advice about a certificate that is not accepted.
std::string certificate_advice(const std::string& reason) {
    if (reason.find("issuer") != std::string::npos || reason.find("self") != std::string::npos)
        return "; --ca FILE names the authority that signed it";
    if (reason.find("mismatch") != std::string::npos)
        return "; the address must have the name that the certificate was made for";
    return "";
}

LinkFailure connection_failure(natsStatus status, const ClusterAddress& address) {
    const std::string servers = fmt::format("{}", fmt::join(address.servers, ","));
    const std::string reason = last_nats_error();
    switch (status) {
        case NATS_NO_SERVER:
            return {fmt::format("cannot reach {}: nothing answers there", servers), false};
        case NATS_SSL_ERROR:
            return {fmt::format("cannot trust the server {}: {}{}", servers, reason,
                                certificate_advice(reason)),
                    true};
        case NATS_SECURE_CONNECTION_WANTED:
            return {fmt::format("the server {} has no encryption; expected one with TLS at tls://",
                                servers),
                    true};
        case NATS_CONNECTION_AUTH_FAILED:
            if (address.credentials.empty())
                return {fmt::format("the server {} wants to know who you are: --credentials FILE",
                                    servers),
                        true};
            return {fmt::format("the server {} does not accept the credentials of {}", servers,
                                address.credentials),
                    true};
        case NATS_PROTOCOL_ERROR:
        case NATS_LINE_TOO_LONG:
        case NATS_TIMEOUT:
        case NATS_IO_ERROR:
            return {fmt::format("no NATS server answers at {} ({})", servers, reason), true};
        default:
            return {fmt::format("cannot connect to {}: {}", servers, reason), true};
    }
}

// Servers refuse one in about 600 signatures that libnats 3.4 makes with the right key. Each
// attempt signs something else.
natsStatus connect_with(natsOptions* options, natsConnection** connection) {
    natsStatus status = NATS_CONNECTION_AUTH_FAILED;
    for (int i = 0; i < kConnectTries && status == NATS_CONNECTION_AUTH_FAILED; ++i)
        status = natsConnection_Connect(connection, options);
    return status;
}

using Failure = std::optional<LinkFailure>;

Failure set_credentials(natsOptions* options, const ClusterAddress& address) {
    if (address.credentials.empty()) return std::nullopt;
    const Result<Credentials> credentials = read_credentials(address.credentials);
    if (!credentials) return LinkFailure{credentials.error().message, true};
    const natsStatus set =
        credentials->user.empty()
            ? natsOptions_SetUserCredentialsFromFiles(options, address.credentials.c_str(), nullptr)
            : natsOptions_SetUserInfo(options, credentials->user.c_str(),
                                      credentials->password.c_str());
    if (set == NATS_OK) return std::nullopt;
    return LinkFailure{fmt::format("{}: {}", address.credentials, last_nats_error()), true};
}

// Host name and chain are always verified.
Failure set_encryption(natsOptions* options, const ClusterAddress& address) {
    if (!address.encrypted) return std::nullopt;
    natsOptions_SetSecure(options, true);
    if (address.authority.empty()) return std::nullopt;
    // The library would wait for the other end of a pipe.
    if (const auto regular = read_file(address.authority, kMostAuthorityBytes); !regular)
        return LinkFailure{"--ca: " + regular.error().message, true};
    if (natsOptions_LoadCATrustedCertificates(options, address.authority.c_str()) == NATS_OK)
        return std::nullopt;
    return LinkFailure{fmt::format("--ca {}: expected a file with certificates (PEM); {}",
                                   address.authority, last_nats_error()),
                       true};
}

Failure check_hosts(const ClusterAddress& address) {
    for (const std::string& server : address.servers) {
        if (is_known_host(host_of(server))) return std::nullopt;
    }
    return LinkFailure{"no host has the name " + host_of(address.servers.front()), true};
}

}  // namespace

// Called by libnats's threads.
class NatsEvents {
public:
    void attach(natsOptions* options) {
        natsOptions_SetErrorHandler(options, &NatsEvents::on_error, this);
        natsOptions_SetDisconnectedCB(options, &NatsEvents::on_lost, this);
        natsOptions_SetClosedCB(options, &NatsEvents::on_closed, this);
    }
    std::uint64_t times_lost() const { return times_lost_.load(); }

    std::vector<std::string> take_complaints() {
        const std::lock_guard lock(mutex_);
        return complaints_.take();
    }
    std::string take_refusal() {
        const std::lock_guard lock(mutex_);
        return std::exchange(refusal_, {});
    }
    // Returns whether libnats has made its last call.
    bool wait_for_end() {
        std::unique_lock lock(mutex_);
        return ended_.wait_for(lock, kLongestGoodbye, [this] { return closed_; });
    }

private:
    static void on_error(natsConnection* connection, natsSubscription* /*subscription*/,
                         natsStatus error, void* closure) {
        const char* words = nullptr;
        natsConnection_GetLastError(connection, &words);
        static_cast<NatsEvents*>(closure)->note_error(error, words == nullptr ? "" : words);
    }
    static void on_lost(natsConnection* /*connection*/, void* closure) {
        ++static_cast<NatsEvents*>(closure)->times_lost_;
    }
    static void on_closed(natsConnection* /*connection*/, void* closure) {
        auto* events = static_cast<NatsEvents*>(closure);
        const std::lock_guard lock(events->mutex_);
        events->closed_ = true;
        events->ended_.notify_all();
    }

    void note_error(natsStatus error, const std::string& words) {
        const std::lock_guard lock(mutex_);
        if (error == NATS_NOT_PERMITTED) {
            refusal_ = fmt::format(
                "the server does not permit this: {}; --credentials names the file of another role",
                text_for_people(words, kLongestWords));
            complaints_.add(refusal_);
        } else if (error == NATS_SLOW_CONSUMER) {
            complaints_.add(
                "messages came faster than they were taken; some are dropped and computed "
                "again");
        }
    }

    std::atomic<std::uint64_t> times_lost_ = 0;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool closed_ = false;
    std::string refusal_;
    Complaints complaints_;
};

std::string last_nats_error() {
    natsStatus status = NATS_OK;
    const char* words = nats_GetLastError(&status);
    std::string_view text = words == nullptr || *words == '\0' ? natsStatus_GetText(status) : words;
    // Removes the prefix of "(conn.c:733): SSL handshake error: ...".
    if (text.starts_with('(')) text.remove_prefix(std::min(text.find("): ") + 3, text.size()));
    return text_for_people(text, kLongestWords);
}

std::variant<std::shared_ptr<NatsSession>, LinkFailure> NatsSession::connect(
    const ClusterAddress& address, const std::string& inbox_prefix) {
    natsOptions* made = nullptr;
    if (natsOptions_Create(&made) != NATS_OK) return LinkFailure{last_nats_error(), true};
    const NatsHandle<natsOptions> options(made);
    if (auto failure = set_credentials(made, address)) return *failure;
    if (auto failure = set_encryption(made, address)) return *failure;
    if (auto failure = check_hosts(address)) return *failure;
    std::vector<const char*> servers;
    for (const std::string& server : address.servers)
        servers.push_back(server.c_str());
    natsOptions_SetServers(made, servers.data(), static_cast<int>(servers.size()));
    natsOptions_SetIgnoreDiscoveredServers(made, true);
    natsOptions_SetName(made, "cambrian");
    natsOptions_SetTimeout(made, kConnectWait);
    natsOptions_SetPingInterval(made, kPingInterval);
    natsOptions_SetMaxPingsOut(made, kPingsUnanswered);
    natsOptions_SetWriteDeadline(made, kWriteWait);
    natsOptions_SetMaxReconnect(made, kMostReconnects);
    natsOptions_SetCustomReconnectDelay(made, reconnect_pause, nullptr);
    natsOptions_SetFailRequestsOnDisconnect(made, true);
    natsOptions_SetSendAsap(made, true);
    natsOptions_SetNoEcho(made, true);

    std::shared_ptr<NatsSession> session(new NatsSession);
    session->inbox_ = fmt::format("{}.{}", inbox_prefix, hex_text(random_id()));
    natsOptions_SetCustomInboxPrefix(made, session->inbox_.c_str());
    session->events_ = std::make_unique<NatsEvents>();
    session->events_->attach(made);
    natsConnection* connection = nullptr;
    const natsStatus status = connect_with(made, &connection);
    if (status != NATS_OK) return connection_failure(status, address);
    session->connection_.reset(connection);
    jsOptions streaming;
    jsOptions_Init(&streaming);
    streaming.Wait = kNatsWait;
    jsCtx* context = nullptr;
    if (natsConnection_JetStream(&context, connection, &streaming) != NATS_OK)
        return LinkFailure{last_nats_error(), true};
    session->jetstream_.reset(context);
    return session;
}

NatsSession::~NatsSession() {
    if (!connection_) return;
    natsConnection_FlushTimeout(connection_.get(), kNatsWait);
    jetstream_.reset();
    natsConnection_Close(connection_.get());
    connection_.reset();
    // If a thread of libnats may still call this object, it must not be destroyed.
    if (!events_->wait_for_end()) static_cast<void>(events_.release());
}

bool NatsSession::connected() const {
    return natsConnection_Status(connection_.get()) == NATS_CONN_STATUS_CONNECTED;
}

bool NatsSession::closed() const {
    return natsConnection_IsClosed(connection_.get());
}

std::uint64_t NatsSession::times_lost() const {
    return events_->times_lost();
}

std::vector<std::string> NatsSession::take_complaints() {
    return events_->take_complaints();
}

std::string NatsSession::take_refusal() {
    return events_->take_refusal();
}

bool NatsSession::send(const std::string& subject, std::string_view body) const {
    return connected() && natsConnection_Publish(connection_.get(), subject.c_str(), body.data(),
                                                 static_cast<int>(body.size())) == NATS_OK;
}

}  // namespace cambrian
