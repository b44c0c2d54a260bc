// The coordinator's side of work_queue.h over NATS JetStream.
#include "cluster/connection/cluster_connection.h"
#include "cluster/nats/nats_link.h"
#include "cluster/nats/nats_streams.h"
#include "cluster/nats/nats_subjects.h"
#include "cluster/nats/nats_subscription.h"
#include "core/text/parsed_number.h"
#include "persist/json/json_text.h"
#include "persist/text/digest_text.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <thread>

namespace cambrian {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::size_t kMostOnTheirWay = 256;  // published units without an acknowledgement
constexpr auto kStoreWait = 3s;
constexpr auto kPauseWhenFull = 500ms;
constexpr auto kPauseWithoutStreams = 500ms;
constexpr auto kLastResults = 300ms;
constexpr std::size_t kHeaderBytes = 1024;       // largest header of a message
constexpr int kMostResultsWaiting = 64'000'000;  // bytes of results not yet polled
constexpr std::size_t kMostAtOnce = 1000;        // results of one poll

// The subscriptions of a coordinator on one connection.
struct CoordinatorSubscriptions {
    NatsSessionPtr session;
    std::shared_ptr<NatsSubscription> acknowledgements;
    std::shared_ptr<NatsSubscription> hellos;
    std::shared_ptr<NatsSubscription> undeliverable;
    std::shared_ptr<NatsSubscription> results;  // null without a run
};
using CoordinatorSubscriptionsPtr = std::shared_ptr<const CoordinatorSubscriptions>;

// A unit that was sent and whose storage the server has not confirmed yet.
struct OnItsWay {
    UnitId unit;
    Clock::time_point given_up;
};

std::uint64_t serial_of(std::string_view subject) {
    subject.remove_prefix(std::min(subject.rfind('.') + 1, subject.size()));
    return parsed_number<std::uint64_t>(subject).value_or(0);
}

// The number under a key of the server's own JSON; 0 if there is none.
std::uint64_t number_in(std::string_view text, const char* key) {
    ErrorList errors;
    const auto root = parse_json(text, JsonLimits{}, errors);
    if (!root || root->kind != JsonValue::Kind::kObject) return 0;
    const JsonValue* value = root->find(key);
    return value != nullptr && value->kind == JsonValue::Kind::kInteger && value->number > 0.0
               ? static_cast<std::uint64_t>(value->number)
               : 0;
}

class NatsCoordinatorQueue final : public CoordinatorQueue {
public:
    NatsCoordinatorQueue(const ClusterAddress& address, std::string_view experiment)
        : subjects_(address.name),
          experiment_(experiment),
          link_(address, subjects_.coordinator_inbox(),
                [this](const NatsSessionPtr& session) { return prepare(session); }) {}
    Status open() { return link_.open(); }

    bool connected() const override { return link_.ready() != nullptr; }
    void begin_run(std::uint64_t run) override;
    bool put_settings(std::string_view key, std::string_view text) override;
    Publishing publish(const UnitMessage& unit) override;
    CoordinatorNews poll(std::chrono::milliseconds longest) override;
    void withdraw(const UnitId& unit) override;
    void withdraw_generation(std::uint64_t run, std::uint32_t generation) override;
    void end_run(std::uint64_t run) override;
    void say_hello(std::string_view sender, std::string_view text) override {
        if (const NatsSessionPtr session = link_.ready())
            session->send(subjects_.coordinator_hello(sender), text);
    }

private:
    std::optional<LinkFailure> prepare(const NatsSessionPtr& session);
    std::optional<LinkFailure> subscribe_results(CoordinatorSubscriptions& made);
    void forget_run_before(NatsSession& session);
    CoordinatorSubscriptionsPtr subscriptions() const {
        const std::lock_guard lock(mutex_);
        return subscriptions_;
    }
    void forget_generation_before(NatsSession& session, const UnitId& unit);
    bool send_unit(NatsSession& session, const UnitMessage& unit);
    void take_hellos(const CoordinatorSubscriptions& from, CoordinatorNews& news) const;
    void take_acknowledgements(const CoordinatorSubscriptions& from);
    void take_acknowledgement(const natsMsg& message);
    void give_up_waiting();
    void take_results(const CoordinatorSubscriptions& from, std::chrono::milliseconds longest,
                      CoordinatorNews& news);
    void take_result(natsMsg& message, CoordinatorNews& news);
    void take_undeliverable(const CoordinatorSubscriptions& from);
    void look_up_undeliverable(NatsSession& session, std::uint64_t sequence);
    void stop_run(NatsSession& session, std::uint64_t run);
    // Deletes the messages of a subject from the stream, without waiting for it.
    void purge(NatsSession& session, const std::string& stream, const std::string& subject);

    const NatsSubjects subjects_;
    const std::string experiment_;
    mutable std::mutex mutex_;
    CoordinatorSubscriptionsPtr subscriptions_;  // of the last connection
    std::optional<std::uint64_t> run_;
    std::optional<std::uint64_t> run_before_;  // run of the same experiment that was killed
    std::uint64_t last_result_ = 0;            // in the stream of results
    std::uint32_t generation_ = 0;             // of the last unit
    std::uint64_t last_serial_ = 0;
    std::map<std::uint64_t, OnItsWay> on_their_way_;  // by serial
    Clock::time_point full_until_{};
    std::vector<UnitId> not_published_;
    std::vector<UnitId> not_deliverable_;
    NatsLink link_;  // last: its thread uses everything above
};

// A run of the same experiment that was killed may have left units.
void NatsCoordinatorQueue::forget_run_before(NatsSession& session) {
    std::optional<std::uint64_t> run;
    {
        const std::lock_guard lock(mutex_);
        run = run_;
    }
    if (experiment_.empty() || !run) return;
    NatsHandle<kvStore> bucket;
    if (open_bucket(session, subjects_, bucket) != NATS_OK) return;
    const std::string key = "run-" + experiment_;
    kvEntry* found = nullptr;
    if (kvStore_Get(&found, bucket.get(), key.c_str()) == NATS_OK) {
        const NatsHandle<kvEntry> entry(found);
        const char* value = kvEntry_ValueString(found);
        const auto before = value == nullptr ? std::nullopt : parse_hex(value);
        if (before && before != run) {
            stop_run(session, *before);
            const std::lock_guard lock(mutex_);
            run_before_ = before;
        }
    }
    kvStore_PutString(nullptr, bucket.get(), key.c_str(), hex_text(*run).c_str());
}

std::optional<LinkFailure> NatsCoordinatorQueue::subscribe_results(CoordinatorSubscriptions& made) {
    std::uint64_t run = 0;
    std::uint64_t last = 0;
    {
        const std::lock_guard lock(mutex_);
        if (!run_) return std::nullopt;
        run = *run_;
        last = last_result_;
    }
    const std::string stream = subjects_.result_stream();
    const std::string subject = subjects_.results_of(run);
    jsSubOptions options;
    jsSubOptions_Init(&options);
    options.Stream = stream.c_str();
    options.Config.AckPolicy = js_AckNone;
    // The server deletes it 30 s after the connection is lost.
    options.Config.InactiveThreshold = std::chrono::nanoseconds(30s).count();
    if (last > 0) {
        options.Config.DeliverPolicy = js_DeliverByStartSequence;
        options.Config.OptStartSeq = last + 1;
    }
    natsSubscription* results = nullptr;
    jsErrCode code = jsErrCode(0);
    const natsStatus status = js_SubscribeSync(&results, made.session->jetstream(), subject.c_str(),
                                               nullptr, &options, &code);
    if (status != NATS_OK) return request_failure(*made.session, status, code, "results");
    natsSubscription_SetPendingLimits(results, -1, kMostResultsWaiting);
    made.results = std::make_shared<NatsSubscription>(made.session, results);
    return std::nullopt;
}

std::optional<LinkFailure> NatsCoordinatorQueue::prepare(const NatsSessionPtr& session) {
    if (auto failure = make_streams(*session, subjects_)) return failure;
    forget_run_before(*session);
    auto made = std::make_shared<CoordinatorSubscriptions>();
    if (const auto before = subscriptions(); before && before->session == session) {
        *made = *before;  // libnats kept these
    } else {
        made->session = session;
        made->acknowledgements =
            NatsSubscription::plain(session, session->inbox() + ".published.*", -1);
        made->hellos = NatsSubscription::plain(session, subjects_.all_hellos(), kMostHellosWaiting);
        made->undeliverable =
            NatsSubscription::plain(session, subjects_.undeliverable(), kMostHellosWaiting);
        if (!made->acknowledgements || !made->hellos || !made->undeliverable)
            return LinkFailure{last_nats_error(), false};
    }
    // A restarted server no longer knows to whom it delivered results.
    if (auto failure = subscribe_results(*made)) return failure;
    const std::lock_guard lock(mutex_);
    subscriptions_ = std::move(made);
    return std::nullopt;
}

void NatsCoordinatorQueue::begin_run(std::uint64_t run) {
    {
        const std::lock_guard lock(mutex_);
        run_ = run;
        last_result_ = 0;
        on_their_way_.clear();
    }
    link_.renew(0ms);
    link_.wait(1s);
}

bool NatsCoordinatorQueue::put_settings(std::string_view key, std::string_view text) {
    const NatsSessionPtr session = link_.ready();
    if (!session || text.size() > kMostSettingsBytes) return false;
    NatsHandle<kvStore> bucket;
    if (open_bucket(*session, subjects_, bucket) != NATS_OK) return false;
    const std::string key_text(key);
    return kvStore_Put(nullptr, bucket.get(), key_text.c_str(), text.data(),
                       static_cast<int>(text.size())) == NATS_OK;
}

// Results of a generation are no longer needed when the next one has begun.
void NatsCoordinatorQueue::forget_generation_before(NatsSession& session, const UnitId& unit) {
    std::uint32_t before = 0;
    {
        const std::lock_guard lock(mutex_);
        before = std::exchange(generation_, unit.generation);
    }
    if (before != unit.generation)
        purge(session, subjects_.result_stream(), subjects_.results_of(unit.run, before));
}

bool NatsCoordinatorQueue::send_unit(NatsSession& session, const UnitMessage& unit) {
    std::string reply;
    std::uint64_t serial = 0;
    {
        const std::lock_guard lock(mutex_);
        serial = ++last_serial_;
        on_their_way_[serial] = {unit.id, Clock::now() + kStoreWait};
        reply = fmt::format("{}.published.{}", session.inbox(), serial);
    }
    const std::string subject = subjects_.work(unit.id);
    natsMsg* made = nullptr;
    bool sent = natsMsg_Create(&made, subject.c_str(), reply.c_str(), unit.body.data(),
                               static_cast<int>(unit.body.size())) == NATS_OK;
    const NatsHandle<natsMsg> message(made);
    sent = sent && natsMsgHeader_Set(made, "Nats-Msg-Id", subject.c_str()) == NATS_OK &&
           natsConnection_PublishMsg(session.connection(), made) == NATS_OK;
    if (sent) return true;
    const std::lock_guard lock(mutex_);
    on_their_way_.erase(serial);
    return false;
}

Publishing NatsCoordinatorQueue::publish(const UnitMessage& unit) {
    const NatsSessionPtr session = link_.ready();
    if (!session) return Publishing::kWait;
    const auto most = natsConnection_GetMaxPayload(session->connection());
    if (unit.body.size() > kMostUnitBytes ||
        static_cast<std::int64_t>(unit.body.size() + kHeaderBytes) > most)
        return Publishing::kTooLarge;
    if (const auto from = subscriptions()) take_acknowledgements(*from);
    {
        const std::lock_guard lock(mutex_);
        if (on_their_way_.size() >= kMostOnTheirWay || Clock::now() < full_until_)
            return Publishing::kWait;
    }
    forget_generation_before(*session, unit.id);
    return send_unit(*session, unit) ? Publishing::kAccepted : Publishing::kWait;
}

void NatsCoordinatorQueue::take_acknowledgement(const natsMsg& message) {
    const std::uint64_t serial = serial_of(subject_of(message));
    const bool stored = number_in(body_of(message), "seq") > 0;
    std::string trouble;
    {
        const std::lock_guard lock(mutex_);
        const auto found = on_their_way_.find(serial);
        if (found == on_their_way_.end()) return;
        if (!stored) {
            not_published_.push_back(found->second.unit);
            full_until_ = Clock::now() + kPauseWhenFull;
        }
        on_their_way_.erase(found);
    }
    if (stored) return;
    // An empty body means that no stream accepts the message.
    if (body_of(message).empty()) return link_.renew(kPauseWithoutStreams);
    link_.complain(
        "the server does not store more work for now, its stream is full; this machine "
        "goes on meanwhile");
}

void NatsCoordinatorQueue::take_acknowledgements(const CoordinatorSubscriptions& from) {
    while (const auto message = from.acknowledgements->next(0ms))
        take_acknowledgement(*message);
}

void NatsCoordinatorQueue::give_up_waiting() {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    for (auto each = on_their_way_.begin(); each != on_their_way_.end();) {
        if (each->second.given_up > now) {
            ++each;
            continue;
        }
        not_published_.push_back(each->second.unit);
        each = on_their_way_.erase(each);
    }
}

void NatsCoordinatorQueue::take_result(natsMsg& message, CoordinatorNews& news) {
    const std::uint64_t sequence = natsMsg_GetSequence(&message);
    const auto unit = subjects_.unit_of(subject_of(message));
    const std::string_view body = body_of(message);
    const std::lock_guard lock(mutex_);
    last_result_ = std::max(last_result_, sequence);
    if (!unit || body.size() > kMostResultBytes) {
        ++news.garbage;
    } else if (run_ && unit->run == *run_) {
        news.results.push_back({*unit, std::string(body), subjects_.login_of(subject_of(message))});
    }
}

void NatsCoordinatorQueue::take_results(const CoordinatorSubscriptions& from,
                                        std::chrono::milliseconds longest, CoordinatorNews& news) {
    while (news.results.size() < kMostAtOnce) {
        const auto message = from.results->next(news.empty() ? longest : 0ms);
        if (!message) return;
        take_result(*message, news);
    }
}

void NatsCoordinatorQueue::look_up_undeliverable(NatsSession& session, std::uint64_t sequence) {
    natsMsg* received = nullptr;
    const std::string stream = subjects_.work_stream();
    if (js_GetMsg(&received, session.jetstream(), stream.c_str(), sequence, nullptr, nullptr) !=
        NATS_OK)
        return;
    const NatsHandle<natsMsg> message(received);
    const auto unit = subjects_.unit_of(subject_of(*message));
    if (unit) {
        const std::lock_guard lock(mutex_);
        if (!run_ || unit->run != *run_) return;  // a unit of another run
        not_deliverable_.push_back(*unit);
    }
    js_DeleteMsg(session.jetstream(), stream.c_str(), sequence, nullptr, nullptr);
}

void NatsCoordinatorQueue::take_undeliverable(const CoordinatorSubscriptions& from) {
    while (const auto message = from.undeliverable->next(0ms)) {
        const std::uint64_t sequence = number_in(body_of(*message), "stream_seq");
        link_.later(
            [this, sequence](NatsSession& session) { look_up_undeliverable(session, sequence); });
    }
}

void NatsCoordinatorQueue::take_hellos(const CoordinatorSubscriptions& from,
                                       CoordinatorNews& news) const {
    while (const auto message = from.hellos->next(0ms)) {
        if (body_of(*message).size() <= kMostHelloBytes) {
            news.hellos.push_back(
                {std::string(body_of(*message)), subjects_.login_of(subject_of(*message))});
        } else {
            ++news.garbage;
        }
    }
}

CoordinatorNews NatsCoordinatorQueue::poll(std::chrono::milliseconds longest) {
    CoordinatorNews news;
    const NatsSessionPtr session = link_.ready();
    const CoordinatorSubscriptionsPtr from = subscriptions();
    if (from) {
        take_acknowledgements(*from);
        take_undeliverable(*from);
        take_hellos(*from, news);
    }
    give_up_waiting();
    {
        const std::lock_guard lock(mutex_);
        news.not_published = std::exchange(not_published_, {});
        news.not_deliverable = std::exchange(not_deliverable_, {});
    }
    news.complaints = link_.take_complaints();
    if (session && from && from->session == session && from->results && from->results->valid()) {
        take_results(*from, longest, news);
        // A worker announces itself before its first result, but on another subscription.
        take_hellos(*from, news);
    } else if (news.empty()) {
        link_.wait(longest);
    }
    return news;
}

void NatsCoordinatorQueue::purge(NatsSession& session, const std::string& stream,
                                 const std::string& subject) {
    session.send("$JS.API.STREAM.PURGE." + stream, json_object({{"filter", quoted_text(subject)}}));
}

// Tells workers to drop their units of a run, and deletes its messages.
void NatsCoordinatorQueue::stop_run(NatsSession& session, std::uint64_t run) {
    session.send(subjects_.stop(run), "");
    purge(session, subjects_.work_stream(), subjects_.work_of(run));
    purge(session, subjects_.result_stream(), subjects_.results_of(run));
}

void NatsCoordinatorQueue::withdraw(const UnitId& unit) {
    if (const NatsSessionPtr session = link_.ready())
        purge(*session, subjects_.work_stream(), subjects_.work(unit));
}

void NatsCoordinatorQueue::withdraw_generation(std::uint64_t run, std::uint32_t generation) {
    const NatsSessionPtr session = link_.ready();
    if (!session) return;
    purge(*session, subjects_.work_stream(), subjects_.work_of(run, generation));
    purge(*session, subjects_.result_stream(), subjects_.results_of(run, generation));
}

void NatsCoordinatorQueue::end_run(std::uint64_t run) {
    const NatsSessionPtr session = link_.ready();
    if (!session) return;
    stop_run(*session, run);
    // Deletes results that were sent before the workers heard it.
    natsConnection_FlushTimeout(session->connection(), kNatsWait);
    std::this_thread::sleep_for(kLastResults);
    purge(*session, subjects_.result_stream(), subjects_.results_of(run));
    const std::lock_guard lock(mutex_);
    if (run_before_) purge(*session, subjects_.result_stream(), subjects_.results_of(*run_before_));
}

}  // namespace

Result<std::unique_ptr<CoordinatorQueue>> connect_coordinator(const ClusterAddress& address,
                                                              std::string_view experiment) {
    auto queue = std::make_unique<NatsCoordinatorQueue>(address, experiment);
    if (const Status opened = queue->open(); !opened) return opened.error();
    return std::unique_ptr<CoordinatorQueue>(std::move(queue));
}

}  // namespace cambrian
