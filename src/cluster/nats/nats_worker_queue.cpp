// The worker's side of work_queue.h over NATS JetStream.
#include "cluster/connection/cluster_connection.h"
#include "cluster/connection/credentials.h"
#include "cluster/nats/nats_link.h"
#include "cluster/nats/nats_pull.h"
#include "cluster/nats/nats_streams.h"
#include "cluster/nats/nats_subjects.h"
#include "cluster/nats/nats_subscription.h"
#include "persist/json/json_text.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <map>
#include <mutex>

namespace cambrian {
namespace {

constexpr std::size_t kMostEndedRuns = 64;
constexpr std::size_t kMostUnitsAtOnce = 1000;
constexpr int kMostHellosHeard = 1024;  // messages not yet polled
constexpr std::chrono::milliseconds kLongestFetch{1000};
constexpr std::chrono::milliseconds kPauseWithoutStream{500};

// The subscriptions of a worker on one connection.
struct WorkerSubscriptions {
    NatsSessionPtr session;
    std::shared_ptr<NatsPull> work;
    std::shared_ptr<NatsSubscription> hellos;
    std::shared_ptr<NatsSubscription> stops;
};
using WorkerSubscriptionsPtr = std::shared_ptr<const WorkerSubscriptions>;

class NatsWorkerQueue final : public WorkerQueue {
public:
    NatsWorkerQueue(const ClusterAddress& address, std::string login)
        : subjects_(address.name),
          login_(std::move(login)),
          link_(address, subjects_.worker_inbox(login_),
                [this](const NatsSessionPtr& s) { return prepare(s); }) {}
    Status open() { return link_.open(); }

    bool connected() const override { return link_.ready() != nullptr; }
    std::vector<Delivery> fetch(std::size_t most, std::chrono::milliseconds longest) override;
    void in_progress(std::uint64_t ticket) override { answer(ticket, "+WPI", false); }
    void acknowledge(std::uint64_t ticket) override { answer(ticket, "+ACK", true); }
    void give_back(std::uint64_t ticket, std::chrono::milliseconds delay) override {
        const auto ns = std::chrono::nanoseconds(delay).count();
        answer(ticket, "-NAK " + json_object({{"delay", std::to_string(ns)}}), true);
    }
    void discard(std::uint64_t ticket) override { answer(ticket, "+TERM", true); }
    bool publish_result(const UnitMessage& result) override;
    FetchedSettings fetch_settings(std::string_view key) override;
    WorkerNews poll() override;
    void say_hello(std::string_view sender, std::string_view text) override {
        if (const NatsSessionPtr session = link_.ready())
            session->send(subjects_.worker_hello(login_, sender), text);
    }

private:
    std::optional<LinkFailure> prepare(const NatsSessionPtr& session);
    WorkerSubscriptionsPtr subscriptions() const {
        const std::lock_guard lock(mutex_);
        return subscriptions_;
    }
    void hear_stops(const WorkerSubscriptions& from);
    bool has_ended(std::uint64_t run);
    void answer(std::uint64_t ticket, const std::string& word, bool last);
    void deliver(natsMsg& message, std::vector<Delivery>& deliveries);

    const NatsSubjects subjects_;
    const std::string login_;
    mutable std::mutex mutex_;
    WorkerSubscriptionsPtr subscriptions_;          // of the last connection
    std::map<std::uint64_t, std::string> tickets_;  // reply subjects of deliveries
    std::uint64_t last_ticket_ = 0;
    std::deque<std::uint64_t> ended_;        // runs, the last ones
    std::vector<std::uint64_t> ended_news_;  // runs that poll() has not reported yet
    const std::string name_ = hex_text(static_cast<std::uint64_t>(nats_NowInNanoSeconds()));
    NatsLink link_;  // last: its thread uses everything above
};

std::optional<LinkFailure> NatsWorkerQueue::prepare(const NatsSessionPtr& session) {
    const std::string stream = subjects_.work_stream();
    jsConsumerInfo* info = nullptr;
    jsErrCode code = jsErrCode(0);
    natsStatus status = js_GetConsumerInfo(&info, session->jetstream(), stream.c_str(),
                                           NatsSubjects::kConsumer, nullptr, &code);
    const NatsHandle<jsConsumerInfo> owner(info);
    if (status == NATS_NOT_FOUND || code == JSStreamNotFoundErr || code == JSConsumerNotFoundErr)
        return LinkFailure{"nobody has evolved on this cluster yet; waiting", false};
    if (status != NATS_OK) return request_failure(*session, status, code, "stream " + stream);
    const auto before = subscriptions();
    if (before && before->session == session && before->work->valid()) return std::nullopt;
    auto made = std::make_shared<WorkerSubscriptions>();
    made->session = session;
    made->work = NatsPull::open(session, stream, NatsSubjects::kConsumer);
    made->hellos =
        NatsSubscription::plain(session, subjects_.coordinator_hellos(), kMostHellosHeard);
    made->stops = NatsSubscription::plain(session, subjects_.all_stops(), kMostHellosHeard);
    if (!made->work || !made->hellos || !made->stops) return LinkFailure{last_nats_error(), false};
    const std::lock_guard lock(mutex_);
    subscriptions_ = std::move(made);
    return std::nullopt;
}

void NatsWorkerQueue::deliver(natsMsg& message, std::vector<Delivery>& deliveries) {
    const char* reply = natsMsg_GetReply(&message);
    if (reply == nullptr) return;
    Delivery delivery;
    const std::lock_guard lock(mutex_);
    delivery.ticket = ++last_ticket_;
    tickets_[delivery.ticket] = reply;
    const auto unit = subjects_.unit_of(subject_of(message));
    const std::string_view body = body_of(message);
    if (!unit || body.size() > kMostUnitBytes) {
        if (const NatsSessionPtr session = link_.ready()) session->send(reply, "+TERM");
        tickets_.erase(delivery.ticket);
        return;
    }
    delivery.unit = {*unit, std::string(body)};
    jsMsgMetaData* received = nullptr;
    if (natsMsg_GetMetaData(&received, &message) == NATS_OK) {
        const NatsHandle<jsMsgMetaData> facts(received);
        delivery.times = static_cast<int>(std::min<std::uint64_t>(facts->NumDelivered, 1000));
    }
    deliveries.push_back(std::move(delivery));
}

std::vector<Delivery> NatsWorkerQueue::fetch(std::size_t most, std::chrono::milliseconds longest) {
    longest = std::clamp(longest, std::chrono::milliseconds(1), kLongestFetch);
    const NatsSessionPtr session = link_.ready();
    const WorkerSubscriptionsPtr from = subscriptions();
    if (!session || !from || from->session != session || most == 0) {
        link_.wait(longest);
        return {};
    }
    const auto messages = from->work->fetch(std::min(most, kMostUnitsAtOnce), longest);
    std::vector<Delivery> deliveries;
    if (!messages) {
        link_.renew(kPauseWithoutStream);
        return deliveries;
    }
    for (const auto& message : *messages)
        deliver(*message, deliveries);
    return deliveries;
}

// A lost acknowledgement only leads to another delivery.
void NatsWorkerQueue::answer(std::uint64_t ticket, const std::string& word, bool last) {
    std::string reply;
    {
        const std::lock_guard lock(mutex_);
        const auto found = tickets_.find(ticket);
        if (found == tickets_.end()) return;
        reply = found->second;
        if (last) tickets_.erase(found);
    }
    if (const NatsSessionPtr session = link_.ready()) session->send(reply, word);
}

void NatsWorkerQueue::hear_stops(const WorkerSubscriptions& from) {
    while (const auto message = from.stops->next(std::chrono::milliseconds(0))) {
        const auto run = subjects_.stopped_run(subject_of(*message));
        if (!run) continue;
        const std::lock_guard lock(mutex_);
        ended_.push_back(*run);
        if (ended_.size() > kMostEndedRuns) ended_.pop_front();
        ended_news_.push_back(*run);
    }
}

bool NatsWorkerQueue::has_ended(std::uint64_t run) {
    if (const WorkerSubscriptionsPtr from = subscriptions()) hear_stops(*from);
    const std::lock_guard lock(mutex_);
    return std::find(ended_.begin(), ended_.end(), run) != ended_.end();
}

bool NatsWorkerQueue::publish_result(const UnitMessage& result) {
    const NatsSessionPtr session = link_.ready();
    if (!session || result.body.size() > kMostResultBytes) return false;
    // The result would never be deleted.
    if (has_ended(result.id.run)) return true;
    const std::string subject = subjects_.result(result.id, login_);
    // Differs from other workers' results of the unit.
    const std::string id = fmt::format("{}.{}", subject, name_);
    jsPubOptions options;
    jsPubOptions_Init(&options);
    options.MaxWait = kNatsWait;
    options.MsgId = id.c_str();
    jsErrCode code = jsErrCode(0);
    const natsStatus status =
        js_Publish(nullptr, session->jetstream(), subject.c_str(), result.body.data(),
                   static_cast<int>(result.body.size()), &options, &code);
    if (status == NATS_NO_RESPONDERS) link_.renew(kPauseWithoutStream);
    return status == NATS_OK;
}

FetchedSettings NatsWorkerQueue::fetch_settings(std::string_view key) {
    const NatsSessionPtr session = link_.ready();
    if (!session) return {};
    NatsHandle<kvStore> bucket;
    if (open_bucket(*session, subjects_, bucket) != NATS_OK) return {};
    kvEntry* found = nullptr;
    const std::string name(key);
    const natsStatus status = kvStore_Get(&found, bucket.get(), name.c_str());
    const NatsHandle<kvEntry> entry(found);
    if (status == NATS_NOT_FOUND) return {SettingsState::kMissing, ""};
    if (status != NATS_OK || kvEntry_ValueLen(found) < 0) return {};
    const auto size = static_cast<std::size_t>(kvEntry_ValueLen(found));
    if (size > kMostSettingsBytes) return {SettingsState::kMissing, ""};
    return {SettingsState::kFound,
            std::string(static_cast<const char*>(kvEntry_Value(found)), size)};
}

WorkerNews NatsWorkerQueue::poll() {
    WorkerNews news;
    news.complaints = link_.take_complaints();
    const WorkerSubscriptionsPtr from = subscriptions();
    if (!from) return news;
    while (const auto message = from->hellos->next(std::chrono::milliseconds(0))) {
        if (body_of(*message).size() <= kMostHelloBytes)
            news.hellos.emplace_back(body_of(*message));
    }
    hear_stops(*from);
    const std::lock_guard lock(mutex_);
    news.ended_runs = std::exchange(ended_news_, {});
    return news;
}

}  // namespace

Result<std::unique_ptr<WorkerQueue>> connect_worker(const ClusterAddress& address) {
    Credentials credentials;
    if (!address.credentials.empty()) {
        const Result<Credentials> read = read_credentials(address.credentials);
        if (!read) return read.error();
        credentials = *read;
    }
    auto queue = std::make_unique<NatsWorkerQueue>(address, credentials.login);
    if (const Status opened = queue->open(); !opened) return opened.error();
    return std::unique_ptr<WorkerQueue>(std::move(queue));
}

}  // namespace cambrian
