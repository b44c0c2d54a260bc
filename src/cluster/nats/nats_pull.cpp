#include "cluster/nats/nats_pull.h"

#include "persist/json/json_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace cambrian {
namespace {

using std::chrono::milliseconds;

std::string answer_subject(const NatsSession& session, std::string_view last) {
    return fmt::format("{}.pull.{}", session.inbox(), last);
}

// Returns the status with which a request has ended, as in HTTP; empty for a message of the stream.
std::string_view status_of(natsMsg& message) {
    const char* status = nullptr;
    const bool has_status = natsMsg_GetDataLength(&message) == 0 &&
                            natsMsgHeader_Get(&message, "Status", &status) == NATS_OK;
    return has_status ? std::string_view(status) : std::string_view();
}

bool is_refusal(std::string_view status) {
    return status != "404" && status != "408";  // no messages; time is up
}

milliseconds time_until(std::chrono::steady_clock::time_point end) {
    const auto left =
        std::chrono::duration_cast<milliseconds>(end - std::chrono::steady_clock::now());
    return std::max(left, milliseconds(0));
}

}  // namespace

std::unique_ptr<NatsPull> NatsPull::open(const NatsSessionPtr& session, const std::string& stream,
                                         const std::string& consumer) {
    auto answers = NatsSubscription::plain(session, answer_subject(*session, "*"), -1);
    if (!answers) return nullptr;
    return std::unique_ptr<NatsPull>(
        new NatsPull(session, std::move(answers),
                     fmt::format("$JS.API.CONSUMER.MSG.NEXT.{}.{}", stream, consumer)));
}

NatsPull::NatsPull(NatsSessionPtr session, std::shared_ptr<NatsSubscription> answers,
                   std::string request_subject)
    : session_(std::move(session)),
      answers_(std::move(answers)),
      request_subject_(std::move(request_subject)) {}

std::optional<NatsPull::Messages> NatsPull::fetch(std::size_t most, milliseconds longest) {
    const Clock::time_point end = Clock::now() + longest;
    Messages messages;
    take_waiting(most, messages);
    bool heard = !messages.empty() || request({.most = most, .wait = false}, end, messages);
    if (heard && messages.empty()) heard = request({.most = 1, .wait = true}, end, messages);
    if (!heard && messages.empty()) return std::nullopt;
    return messages;
}

void NatsPull::take_waiting(std::size_t most, Messages& messages) const {
    while (messages.size() < most) {
        auto message = answers_->next(milliseconds(0));
        if (!message) return;
        if (status_of(*message).empty()) messages.push_back(std::move(message));
    }
}

bool NatsPull::request(const Wanted& wanted, Clock::time_point end, Messages& messages) {
    const std::string subject = answer_subject(*session_, std::to_string(++requests_));
    if (!send(wanted, end, subject)) return false;
    while (messages.size() < wanted.most) {
        auto message = answers_->next(time_until(end));
        if (!message) return true;
        const std::string_view status = status_of(*message);
        if (status.empty()) {
            messages.push_back(std::move(message));
        } else if (subject_of(*message) == subject) {
            return !is_refusal(status);
        }
    }
    return true;
}

bool NatsPull::send(const Wanted& wanted, Clock::time_point end, const std::string& answers) {
    const auto expires = std::chrono::nanoseconds(time_until(end) + milliseconds(1)).count();
    const std::string batch = std::to_string(wanted.most);
    const std::string body =
        wanted.wait ? json_object({{"batch", batch}, {"expires", std::to_string(expires)}})
                    : json_object({{"batch", batch}, {"no_wait", "true"}});
    return natsConnection_PublishRequest(session_->connection(), request_subject_.c_str(),
                                         answers.c_str(), body.data(),
                                         static_cast<int>(body.size())) == NATS_OK;
}

}  // namespace cambrian
