#pragma once

// Which machines evaluate, for display. No result of a run depends on it.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

enum class WorkerState : std::uint8_t {
    kWorking,
    kIdle,     // heard from, nothing to do
    kAway,     // not heard from for longer than it should be silent
    kRefused,  // its results are not taken
};

// A process that evaluates: this program's own cores, or a worker on any machine.
struct WorkerStatus {
    std::string id;    // unique among the workers of a status; empty for the own cores
    std::string name;  // as shown; at most 40 characters
    std::uint32_t cores = 0;
    WorkerState state = WorkerState::kIdle;
    double silent_seconds = 0.0;        // s since it was last heard from
    std::string refusal;                // why, in words, if kRefused: "other bits"
    double creatures_per_second = 0.0;  // of the last seconds
    double share = 0.0;                 // 0 to 1, of the last minute's EvaluationResult::work
    std::uint64_t checks_passed = 0;    // creatures computed again elsewhere with equal bits
};

// Since the back-end began; all but `overdue_at_home` and `poisoned` count what came over the
// network.
struct BackendCounts {
    std::uint64_t units = 0;            // published
    std::uint64_t redelivered = 0;      // handed out more than once
    std::uint64_t duplicates = 0;       // results of slots that had one
    std::uint64_t overdue_at_home = 0;  // overdue units computed by the own cores
    std::uint64_t checked = 0;          // creatures computed again at home
    std::uint64_t refused = 0;          // results not taken, since their worker is refused
    std::uint64_t malformed = 0;        // messages that could not be read
    std::uint64_t poisoned = 0;         // units computed in a process of their own
};

enum class ClusterLink : std::uint8_t {
    kNone,        // no cluster: this machine alone
    kConnecting,  // not reached yet
    kConnected,
    kAway,  // was reached and is not now: working alone
};

struct BackendStatus {
    ClusterLink link = ClusterLink::kNone;
    std::string server;   // as the person gave it; empty if kNone
    std::string cluster;  // its name; empty if kNone
    std::string trouble;  // the last thing that went wrong and what to do about it; empty if none
    std::string failure;  // why no run can go on with this back-end; empty while it can
    std::vector<WorkerStatus> workers;  // the own cores first, then by name and id
    BackendCounts counts;
    // Number of cores that the run can use; more cores would mostly wait. 0 while unknown.
    double useful_cores = 0.0;
};

// Sums over the workers that take part, without absent and refused ones.
struct WorkerTotals {
    std::uint32_t machines = 0;
    std::uint32_t cores = 0;
    double creatures_per_second = 0.0;
};

inline bool takes_part(const WorkerStatus& worker) {
    return worker.state == WorkerState::kWorking || worker.state == WorkerState::kIdle;
}

inline WorkerTotals totals(const BackendStatus& status) {
    WorkerTotals sum;
    for (const WorkerStatus& worker : status.workers) {
        if (!takes_part(worker)) continue;
        ++sum.machines;
        sum.cores += worker.cores;
        sum.creatures_per_second += worker.creatures_per_second;
    }
    return sum;
}

// Cores at which a generation of `work` (core-seconds) spends a quarter of its time, `overhead` (s)
// in all, waiting rather than evaluating. Both above 0.
inline double useful_cores(double work, double overhead) {
    return std::max(1.0, work / (3.0 * overhead));
}

}  // namespace cambrian
