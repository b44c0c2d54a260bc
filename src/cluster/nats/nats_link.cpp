#include "cluster/nats/nats_link.h"

#include <algorithm>
#include <variant>

namespace cambrian {
namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 50ms;         // between looks at the connection
constexpr auto kFirstPause = 100ms;  // between attempts to connect
constexpr auto kLongestPause = 1500ms;
constexpr auto kPauseAfterMistake = 5000ms;  // permanent errors are retried rarely
constexpr std::size_t kMostJobs = 10'000;

}  // namespace

NatsLink::NatsLink(ClusterAddress address, std::string inbox, Prepare prepare)
    : address_(std::move(address)), inbox_(std::move(inbox)), prepare_(std::move(prepare)) {}

NatsLink::~NatsLink() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

std::optional<LinkFailure> NatsLink::attempt() {
    NatsSessionPtr session;
    {
        const std::lock_guard lock(mutex_);
        session = session_;
    }
    if (!session || session->closed()) {
        auto connected = NatsSession::connect(address_, inbox_);
        if (auto* failure = std::get_if<LinkFailure>(&connected)) return *failure;
        session = std::get<NatsSessionPtr>(connected);
        const std::lock_guard lock(mutex_);
        session_ = session;
    }
    const std::uint64_t losses = session->times_lost();
    if (!session->connected()) return LinkFailure{"lost the connection to the server", false};
    if (auto failure = prepare_(session)) return failure;
    const std::lock_guard lock(mutex_);
    losses_ = losses;
    prepared_ = true;
    changed_.notify_all();
    return std::nullopt;
}

Status NatsLink::open() {
    const auto failure = attempt();
    if (failure && failure->lasting) return Error{failure->message};
    if (failure) complain(failure->message + "; trying again");
    thread_ = std::jthread([this](const std::stop_token& stop) { keep(stop); });
    return {};
}

bool NatsLink::is_ready_locked() const {
    return session_ && prepared_ && session_->connected() && session_->times_lost() == losses_;
}

NatsSessionPtr NatsLink::ready() const {
    const std::lock_guard lock(mutex_);
    return is_ready_locked() ? session_ : nullptr;
}

void NatsLink::renew(std::chrono::milliseconds pause) {
    const std::lock_guard lock(mutex_);
    prepared_ = false;
    renewed_ = true;
    not_before_ = std::chrono::steady_clock::now() + pause;
    changed_.notify_all();
}

void NatsLink::later(Job job) {
    const std::lock_guard lock(mutex_);
    if (jobs_.size() < kMostJobs) jobs_.push_back(std::move(job));
    changed_.notify_all();
}

void NatsLink::complain(const std::string& words) {
    const std::lock_guard lock(mutex_);
    complaints_.add(words);
}

std::vector<std::string> NatsLink::take_complaints() {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> all = complaints_.take();
    if (!session_) return all;
    for (std::string& words : session_->take_complaints())
        all.push_back(std::move(words));
    return all;
}

void NatsLink::wait(std::chrono::milliseconds longest) const {
    std::unique_lock lock(mutex_);
    const bool before = is_ready_locked();
    const auto end = std::chrono::steady_clock::now() + longest;
    // libnats notices losses on threads of its own.
    while (is_ready_locked() == before && std::chrono::steady_clock::now() < end)
        changed_.wait_until(lock, std::min(end, std::chrono::steady_clock::now() + kTick));
}

std::chrono::milliseconds NatsLink::pause_after(const LinkFailure& failure) {
    complain(failure.message);
    const auto pause = std::min<std::chrono::milliseconds>(
        kFirstPause * (1 << std::min(failures_, 10)), kLongestPause);
    ++failures_;
    if (failure.lasting) return kPauseAfterMistake;
    return pause / 2 + std::chrono::milliseconds(nats_NowInNanoSeconds() % (pause / 2).count());
}

void NatsLink::do_jobs(NatsSession& session) {
    for (;;) {
        Job job;
        {
            const std::lock_guard lock(mutex_);
            if (jobs_.empty() || !is_ready_locked()) return;
            job = std::move(jobs_.front());
            jobs_.pop_front();
        }
        job(session);
    }
}

bool NatsLink::is_too_early() const {
    const std::lock_guard lock(mutex_);
    return std::chrono::steady_clock::now() < not_before_;
}

void NatsLink::keep(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::chrono::milliseconds pause = kTick;
        if (const NatsSessionPtr session = ready()) {
            failures_ = 0;
            do_jobs(*session);
        } else if (is_too_early()) {
            pause = kTick;
        } else if (const auto failure = attempt()) {
            pause = pause_after(*failure);
        }
        std::unique_lock lock(mutex_);
        const auto wanted = [this] { return renewed_ || (!jobs_.empty() && is_ready_locked()); };
        changed_.wait_for(lock, stop, pause, wanted);
        renewed_ = false;
    }
    if (const NatsSessionPtr session = ready()) do_jobs(*session);
}

}  // namespace cambrian
