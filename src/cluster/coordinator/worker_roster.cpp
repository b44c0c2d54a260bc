#include "cluster/coordinator/worker_roster.h"

#include "cluster/coordinator/trust.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace cambrian {
namespace {

constexpr double kAway = 6.0;         // s of silence after which a worker gets no units
constexpr double kForgotten = 300.0;  // s of silence after which it is no longer listed
constexpr std::size_t kMostMembers = 4'096;
constexpr std::size_t kMostOfLogin = 2'048;  // no login keeps the others' workers from the roll

}  // namespace

WorkerRoster::WorkerRoster(Build build, std::string own_name, std::size_t own_cores)
    : build_(std::move(build)), own_name_(std::move(own_name)), own_cores_(own_cores) {}

bool WorkerRoster::has_room_for(const std::string& login) const {
    if (members_.size() >= kMostMembers) return false;
    const auto of_login = std::count_if(members_.begin(), members_.end(), [&](const auto& entry) {
        return entry.second.login == login;
    });
    return static_cast<std::size_t>(of_login) < kMostOfLogin;
}

void WorkerRoster::hear(const Hello& hello, const std::string& login, double now,
                        const Trust& trust) {
    if (hello.role != Hello::Role::kWorker) return;
    forget_silent(now);
    const auto known = members_.find(hello.id);
    if (known != members_.end() && known->second.login != login) return;
    if (hello.leaving && !trust.refused(hello.id)) {
        members_.erase(hello.id);
        return;
    }
    if (known == members_.end() && !has_room_for(login)) return;
    Member& member = members_[hello.id];
    member.hello = hello;
    member.login = login;
    member.heard = now;
    member.doubted = false;
}

bool WorkerRoster::counts(std::uint64_t worker, const std::string& login) const {
    const auto found = members_.find(worker);
    return found != members_.end() && found->second.login == login &&
           found->second.hello.simulator == build_.simulator &&
           found->second.hello.proof == build_.proof;
}

std::string WorkerRoster::login_of(std::uint64_t worker) const {
    const auto found = members_.find(worker);
    return found == members_.end() ? std::string() : found->second.login;
}

void WorkerRoster::forget_silent(double now) {
    std::erase_if(members_,
                  [&](const auto& entry) { return now - entry.second.heard > kForgotten; });
}

void WorkerRoster::worked(std::uint64_t worker, std::uint64_t creatures, std::uint64_t work,
                          double now) {
    const auto found = members_.find(worker);
    if (found == members_.end()) return;
    Member& member = found->second;
    member.recent.add(now, creatures, work);
    member.heard = now;
    member.doubted = false;
}

void WorkerRoster::doubt_silent(double since) {
    for (auto& [id, member] : members_) {
        if (member.heard < since) member.doubted = true;
    }
}

void WorkerRoster::worked_at_home(std::uint64_t creatures, std::uint64_t work, double now) {
    own_.add(now, creatures, work);
}

std::string WorkerRoster::refusal(const Member& member, const Trust& trust) const {
    const Hello& hello = member.hello;
    if (trust.refused(hello.id)) return trust.refusal(hello.id);
    if (hello.simulator != build_.simulator)
        return fmt::format("simulator {}, this run is of {}", hello.simulator, build_.simulator);
    if (hello.proof != build_.proof) return "other bits in the proof set";
    return {};
}

std::size_t WorkerRoster::cores(double now, const Trust& trust) const {
    std::size_t sum = 0;
    for (const auto& [id, member] : members_) {
        if (now - member.heard <= kAway && !member.doubted && refusal(member, trust).empty())
            sum += static_cast<std::size_t>(member.hello.cores);
    }
    return sum;
}

std::vector<WorkerStatus> WorkerRoster::rows(double now, const Trust& trust,
                                             const View& view) const {
    std::vector<WorkerStatus> rows;
    double whole = own_.work.sum(now);
    for (const auto& [id, member] : members_)
        whole += member.recent.work.sum(now);
    const auto share = [&](const RecentWork& recent) {
        return whole > 0.0 ? recent.work.sum(now) / whole : 0.0;
    };
    for (const auto& [id, member] : members_) {
        WorkerStatus row;
        row.id = hex_text(id);
        row.name = member.hello.name;
        row.cores = static_cast<std::uint32_t>(member.hello.cores);
        row.silent_seconds = now - member.heard;
        row.refusal = refusal(member, trust);
        row.state = member.hello.busy > 0 ? WorkerState::kWorking : WorkerState::kIdle;
        if (!view.reachable || row.silent_seconds > kAway) row.state = WorkerState::kAway;
        if (!row.refusal.empty()) row.state = WorkerState::kRefused;
        row.creatures_per_second = member.recent.creatures_per_second(now);
        row.share = share(member.recent);
        row.checks_passed = trust.checks_passed(id);
        rows.push_back(std::move(row));
    }
    std::sort(rows.begin(), rows.end(), [](const WorkerStatus& a, const WorkerStatus& b) {
        return std::tie(a.name, a.id) < std::tie(b.name, b.id);
    });
    WorkerStatus own;
    own.name = own_name_;
    own.cores = static_cast<std::uint32_t>(own_cores_);
    own.state = view.own_busy ? WorkerState::kWorking : WorkerState::kIdle;
    own.creatures_per_second = own_.creatures_per_second(now);
    own.share = share(own_);
    rows.insert(rows.begin(), std::move(own));
    return rows;
}

}  // namespace cambrian
