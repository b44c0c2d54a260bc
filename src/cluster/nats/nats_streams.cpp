#include "cluster/nats/nats_streams.h"

#include <fmt/core.h>

#include <chrono>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace cambrian {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // ns
constexpr std::int64_t kMegabyte = 1'000'000;    // bytes
constexpr std::int64_t kStreamBytes = 256 * kMegabyte;
constexpr std::int64_t kBucketBytes = 64 * kMegabyte;
constexpr std::int64_t kLongestKept = 3600 * kSecond;
constexpr std::int64_t kSettingsKept = 30 * 24 * 3600 * kSecond;
constexpr std::int64_t kDuplicateWindow = 120 * kSecond;
constexpr std::int64_t kWorkWait = 10 * kSecond;
constexpr std::int64_t kMostDeliveries = 5;
constexpr std::int64_t kMostUnacknowledged = 20'000;
constexpr std::int64_t kMostWaiting = 4096;
constexpr int kCreationTries = 3;
constexpr std::chrono::milliseconds kBetweenTries{100};

using Failure = std::optional<LinkFailure>;

// Collects the differences between two settings as text.
class Differences {
public:
    void compare(const char* name, const std::string& found, const std::string& expected) {
        if (found == expected) return;
        text_ +=
            fmt::format("{}{} {} (expected {})", text_.empty() ? "" : "; ", name, found, expected);
    }
    void compare(const char* name, std::int64_t found, std::int64_t expected) {
        compare(name, std::to_string(found), std::to_string(expected));
    }
    void compare_seconds(const char* name, std::int64_t found, std::int64_t expected) {
        compare(name, fmt::format("{} s", found / kSecond),
                fmt::format("{} s", expected / kSecond));
    }
    // Returns a failure if there are differences.
    Failure found_in(const std::string& what) const {
        if (text_.empty()) return std::nullopt;
        return LinkFailure{fmt::format("the server has {} with other settings: {}; delete it there "
                                       "or choose another --cluster-name",
                                       what, text_),
                           true};
    }

private:
    std::string text_;
};

const char* retention_word(jsRetentionPolicy retention) {
    return retention == js_WorkQueuePolicy  ? "work queue"
           : retention == js_InterestPolicy ? "interest"
                                            : "limits";
}

std::string subjects_text(const jsStreamConfig& config) {
    std::string text;
    for (int i = 0; i < config.SubjectsLen; ++i)
        text.append(text.empty() ? "" : " ").append(config.Subjects[i]);
    return text;
}

Failure compare_streams(const jsStreamConfig& found, const jsStreamConfig& expected) {
    Differences differences;
    differences.compare("subjects", subjects_text(found), subjects_text(expected));
    differences.compare("retention", retention_word(found.Retention),
                        retention_word(expected.Retention));
    differences.compare("storage", found.Storage == js_MemoryStorage ? "in memory" : "in files",
                        expected.Storage == js_MemoryStorage ? "in memory" : "in files");
    differences.compare("discard", found.Discard == js_DiscardNew ? "new" : "old",
                        expected.Discard == js_DiscardNew ? "new" : "old");
    differences.compare("bytes", found.MaxBytes, expected.MaxBytes);
    differences.compare_seconds("age", found.MaxAge, expected.MaxAge);
    differences.compare_seconds("duplicate window", found.Duplicates, expected.Duplicates);
    return differences.found_in("a stream " + std::string(expected.Name));
}

// A server sometimes fails to make a folder for the first stream of an account, and then succeeds.
natsStatus add_stream(NatsSession& session, jsStreamConfig& config, jsErrCode& code) {
    natsStatus status = NATS_OK;
    for (int tries = 0; tries < kCreationTries; ++tries) {
        if (tries > 0) std::this_thread::sleep_for(kBetweenTries);
        code = jsErrCode(0);
        status = js_AddStream(nullptr, session.jetstream(), &config, nullptr, &code);
        if (status == NATS_OK || code != JSStreamCreateErr) return status;
    }
    return status;
}

Failure make_stream(NatsSession& session, jsStreamConfig& config) {
    jsStreamInfo* received = nullptr;
    jsErrCode code = jsErrCode(0);
    natsStatus status =
        js_GetStreamInfo(&received, session.jetstream(), config.Name, nullptr, &code);
    const NatsHandle<jsStreamInfo> info(received);
    if (status == NATS_OK) return compare_streams(*info->Config, config);
    if (status != NATS_NOT_FOUND)
        return request_failure(session, status, code, std::string("stream ") + config.Name);
    status = add_stream(session, config, code);
    if (status == NATS_OK) return std::nullopt;
    return request_failure(session, status, code, std::string("stream ") + config.Name);
}

Failure make_stream_of(NatsSession& session, const std::string& name, const std::string& subjects,
                       jsRetentionPolicy retention, jsDiscardPolicy discard) {
    const char* subject = subjects.c_str();
    jsStreamConfig config;
    jsStreamConfig_Init(&config);
    config.Name = name.c_str();
    config.Subjects = &subject;
    config.SubjectsLen = 1;
    config.Storage = js_FileStorage;
    config.MaxBytes = kStreamBytes;
    config.MaxAge = kLongestKept;
    config.Duplicates = kDuplicateWindow;
    config.Retention = retention;
    config.Discard = discard;
    return make_stream(session, config);
}

Failure make_consumer(NatsSession& session, const NatsSubjects& subjects) {
    const std::string stream = subjects.work_stream();
    const std::string all = subjects.all_work();
    jsConsumerInfo* received = nullptr;
    jsErrCode code = jsErrCode(0);
    natsStatus status = js_GetConsumerInfo(&received, session.jetstream(), stream.c_str(),
                                           NatsSubjects::kConsumer, nullptr, &code);
    const NatsHandle<jsConsumerInfo> info(received);
    if (status == NATS_OK) {
        Differences differences;
        differences.compare_seconds("acknowledgement after", info->Config->AckWait, kWorkWait);
        differences.compare("deliveries", info->Config->MaxDeliver, kMostDeliveries);
        differences.compare("unacknowledged", info->Config->MaxAckPending, kMostUnacknowledged);
        differences.compare("waiting", info->Config->MaxWaiting, kMostWaiting);
        return differences.found_in(
            fmt::format("a consumer {} of {}", NatsSubjects::kConsumer, stream));
    }
    if (status == NATS_NOT_FOUND) {
        jsConsumerConfig config;
        jsConsumerConfig_Init(&config);
        config.Durable = NatsSubjects::kConsumer;
        config.FilterSubject = all.c_str();
        config.AckPolicy = js_AckExplicit;
        config.AckWait = kWorkWait;
        config.MaxDeliver = kMostDeliveries;
        config.MaxAckPending = kMostUnacknowledged;
        config.MaxWaiting = kMostWaiting;
        status =
            js_AddConsumer(nullptr, session.jetstream(), stream.c_str(), &config, nullptr, &code);
        if (status == NATS_OK) return std::nullopt;
    }
    return request_failure(session, status, code, "the consumer of " + stream);
}

Failure make_bucket(NatsSession& session, const NatsSubjects& subjects) {
    const std::string name = subjects.bucket();
    NatsHandle<kvStore> bucket;
    natsStatus status = open_bucket(session, subjects, bucket);
    if (status == NATS_NOT_FOUND) {
        kvConfig config;
        kvConfig_Init(&config);
        config.Bucket = name.c_str();
        config.History = 1;
        config.TTL = kSettingsKept;
        config.MaxBytes = kBucketBytes;
        config.MaxValueSize = static_cast<std::int32_t>(kMostSettingsBytes);
        config.StorageType = js_FileStorage;
        kvStore* made = nullptr;
        status = js_CreateKeyValue(&made, session.jetstream(), &config);
        bucket.reset(made);
    }
    if (status == NATS_OK) return std::nullopt;
    return request_failure(session, status, jsErrCode(0), "bucket " + name);
}

}  // namespace

natsStatus open_bucket(const NatsSession& session, const NatsSubjects& subjects,
                       NatsHandle<kvStore>& bucket) {
    kvStore* opened = nullptr;
    const std::string name = subjects.bucket();
    const natsStatus status = js_KeyValue(&opened, session.jetstream(), name.c_str());
    bucket.reset(opened);
    return status;
}

LinkFailure request_failure(NatsSession& session, natsStatus status, jsErrCode code,
                            const std::string& what) {
    const std::string refusal = session.take_refusal();
    if (!refusal.empty()) return {refusal, true};
    if (status == NATS_NO_RESPONDERS || code == JSNotEnabledErr ||
        code == JSNotEnabledForAccountErr)
        return {"the server has no JetStream: start it with -js or the sample configuration", true};
    const bool lost = status == NATS_TIMEOUT || status == NATS_CONNECTION_DISCONNECTED ||
                      status == NATS_CONNECTION_CLOSED;
    return {fmt::format("the server did not give {}: {}", what, last_nats_error()), !lost};
}

std::optional<LinkFailure> make_streams(NatsSession& session, const NatsSubjects& subjects) {
    // A full stream of work accepts no more; results are replaced by later ones.
    if (auto failure = make_stream_of(session, subjects.work_stream(), subjects.all_work(),
                                      js_WorkQueuePolicy, js_DiscardNew))
        return failure;
    if (auto failure = make_consumer(session, subjects)) return failure;
    if (auto failure = make_stream_of(session, subjects.result_stream(), subjects.all_results(),
                                      js_LimitsPolicy, js_DiscardOld))
        return failure;
    return make_bucket(session, subjects);
}

}  // namespace cambrian
