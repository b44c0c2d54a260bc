#include "studio/machines/machine_words.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {
namespace {

std::string with_reason(std::string words, const std::string& reason) {
    if (!reason.empty()) words += ": " + reason;
    return words;
}

std::string server_words(const MachinesView& machines) {
    return machines.login.servers.empty() ? "the cluster" : machines.login.servers;
}

}  // namespace

std::string state_words(const WorkerStatus& worker) {
    switch (worker.state) {
        case WorkerState::kWorking:
            return "working";
        case WorkerState::kIdle:
            return "idle";
        case WorkerState::kAway:
            return "away " + with_unit(std::round(worker.silent_seconds), "s");
        case WorkerState::kRefused:
            break;
    }
    return with_reason("refused", worker.refusal);
}

std::string totals_words(const BackendStatus& status) {
    const WorkerTotals sum = totals(status);
    return fmt::format("{} · {} · {} creatures/s", counted(sum.machines, "machine"),
                       counted(sum.cores, "core"),
                       pretty_number(std::round(sum.creatures_per_second)));
}

std::string useful_cores_words(const BackendStatus& status) {
    if (status.useful_cores <= 0.0) return "";
    return "This run can use about " +
           counted(static_cast<std::size_t>(std::round(status.useful_cores)), "core");
}

std::string machines_words(const MachinesView& machines) {
    const BackendStatus& status = machines.status;
    if (machines.joining) return fmt::format("Reaching {}…", server_words(machines));
    if (!machines.joined) return with_reason("Working alone", machines.problem);
    if (!status.failure.empty()) return status.failure;
    switch (status.link) {
        case ClusterLink::kNone:
        case ClusterLink::kConnecting:
            return with_reason(
                fmt::format("Working alone until {} answers", server_words(machines)),
                status.trouble);
        case ClusterLink::kAway:
            return with_reason("Cluster away, working alone", status.trouble);
        case ClusterLink::kConnected:
            break;
    }
    const std::string useful = useful_cores_words(status);
    return totals_words(status) + (useful.empty() ? "" : " · " + useful);
}

bool troubled(const MachinesView& machines) {
    if (machines.joining) return false;
    return !machines.joined || machines.status.link != ClusterLink::kConnected ||
           !machines.status.failure.empty();
}

}  // namespace cambrian
