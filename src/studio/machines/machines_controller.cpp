#include "studio/machines/machines_controller.h"

#include "cluster/join_cluster.h"
#include "core/text/pretty_text.h"
#include "evolution/backends/thread_pool_backend.h"
#include "studio/machines/machine_words.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <variant>

namespace cambrian {
namespace {

constexpr double kReadingInterval = 0.25;  // s between two readings of the status

const char* name_of(ClusterLink link) {
    switch (link) {
        case ClusterLink::kNone:
            break;
        case ClusterLink::kConnecting:
            return "connecting";
        case ClusterLink::kConnected:
            return "connected";
        case ClusterLink::kAway:
            return "away";
    }
    return "none";
}

// Destroys a back-end on the worker's thread, since closing its connection may take a moment.
void give_up(const Services& services, std::shared_ptr<EvaluationBackend> backend) {
    services.worker.submit([backend = std::move(backend)](const std::stop_token&) mutable {
        backend.reset();
        return [] {};
    });
}

}  // namespace

// The result of an attempt to join a cluster.
struct MachinesController::Attempt {
    unsigned number = 0;
    std::shared_ptr<EvaluationBackend> backend;  // null if it failed
    std::string problem;
    std::string warning;  // warning about files that others can read; empty if none
};

MachinesController::Attempt MachinesController::attempt_to_join(const ClusterLogin& login,
                                                                const ThreadShare& threads,
                                                                const ClusterJoining& join) {
    Attempt attempt;
    if (!join) {
        attempt.problem = "this window evaluates nothing on other machines";
        return attempt;
    }
    const Result<ClusterAddress> address = cluster_address(login);
    if (!address) {
        attempt.problem = address.error().message;
        return attempt;
    }
    if (auto backend = join(*address, threads)) {
        attempt.backend = *std::move(backend);
        attempt.warning = fmt::format("{}", fmt::join(openness_warnings(*address), "; "));
    } else {
        attempt.problem = backend.error().message;
    }
    return attempt;
}

// Has one overload for each kind of request.
struct MachinesController::Handler {
    MachinesController& self;

    void operator()(const ToggleMachines&) const { self.facts_.card_open = !self.facts_.card_open; }
    void operator()(const JoinCluster& request) const { self.join(request.login); }
    void operator()(const LeaveCluster&) const { self.leave(); }
};

MachinesController::MachinesController(const Services& services, ExperimentController& experiment,
                                       MachineOptions options)
    : services_(services),
      experiment_(experiment),
      options_(std::move(options)),
      own_(make_thread_pool_backend(services.kinds, options_.threads.workers,
                                    options_.threads.priority)),
      used_(own_) {}

void MachinesController::begin(const ClusterMemory& remembered) {
    facts_.login = options_.cluster.value_or(remembered.login);
    if (options_.cluster || remembered.joined) join(facts_.login);
}

void MachinesController::carry_out(const MachinesRequest& request) {
    std::visit(Handler{*this}, request);
}

ClusterMemory MachinesController::memory() const {
    return {facts_.login, cluster_wanted(facts_)};
}

void MachinesController::join(const ClusterLogin& login) {
    leave();
    facts_.login = login;
    facts_.joining = true;
    services_.worker.submit([this, login, number = attempts_, join = options_.join,
                             threads = options_.threads](const std::stop_token& stop) {
        Attempt attempt;
        if (!stop.stop_requested()) attempt = attempt_to_join(login, threads, join);
        attempt.number = number;
        return [this, attempt] { finish(attempt); };
    });
}

void MachinesController::leave() {
    ++attempts_;
    facts_.joining = false;
    facts_.joined = false;
    facts_.problem.clear();
    if (used_ == own_) return;
    std::shared_ptr<EvaluationBackend> before = used_;
    use(own_);
    give_up(services_, std::move(before));
    services_.feedback.log().write("cluster left");
}

void MachinesController::finish(const Attempt& attempt) {
    if (attempt.number != attempts_) {
        if (attempt.backend) give_up(services_, attempt.backend);
        return;
    }
    facts_.joining = false;
    if (!attempt.backend) {
        facts_.problem = attempt.problem;
        services_.feedback.log().write("cluster refused", {{"problem", attempt.problem}});
        if (!facts_.card_open)
            services_.feedback.tell(NoticeKind::kProblem, machines_words(facts_) +
                                                              ". File > Work on several machines "
                                                              "tries again.");
        return;
    }
    facts_.joined = true;
    use(attempt.backend);
    if (!attempt.warning.empty())
        services_.feedback.tell(NoticeKind::kProblem, capitalized(attempt.warning) + ".");
    services_.feedback.log().write("cluster joined", {{"server", facts_.login.servers}});
}

void MachinesController::use(std::shared_ptr<EvaluationBackend> backend) {
    used_ = std::move(backend);
    experiment_.open().send(UseBackend{used_});
    read_at_ = -1.0;
}

void MachinesController::update(double now) {
    if (read_at_ >= 0.0 && now - read_at_ < kReadingInterval) return;
    read_at_ = now;
    const BackendStatus before = std::exchange(facts_.status, used_->status());
    tell_changes(before);
}

void MachinesController::tell_changes(const BackendStatus& before) {
    const BackendStatus& now = facts_.status;
    const bool away = now.link == ClusterLink::kAway;
    if (away && before.link == ClusterLink::kConnected)
        services_.feedback.tell(
            NoticeKind::kProblem,
            machines_words(facts_) + ". Its machines are used again as soon as it is back.");
    if (before.link == ClusterLink::kAway && now.link == ClusterLink::kConnected)
        services_.feedback.tell(NoticeKind::kDone, "The cluster is back.");
    const WorkerTotals sum = totals(now);
    const WorkerTotals then = totals(before);
    if (now.link == before.link && sum.machines == then.machines && sum.cores == then.cores) return;
    services_.feedback.log().write("machines", {{"link", std::string(name_of(now.link))},
                                                {"machines", static_cast<double>(sum.machines)},
                                                {"cores", static_cast<double>(sum.cores)}});
}

}  // namespace cambrian
