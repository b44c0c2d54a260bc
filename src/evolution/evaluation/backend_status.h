#pragma once

// Which machines evaluate, for display. No result of a run depends on it.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

enum class WorkerState : std::uint8_t {
    kWorking,
    kIdle,     // known, but has nothing to do
    kAway,     // silent for longer than it should be
    kRefused,  // its results are not accepted
};

// A process that evaluates: this program with its own cores, or a worker on any machine.
struct WorkerStatus {
    std::string id;    // unique in a status; empty for this program's own cores
    std::string name;  // displayed name; at most 40 characters
    std::uint32_t cores = 0;
    WorkerState state = WorkerState::kIdle;
    double silent_seconds = 0.0;        // s since its last message
    std::string refusal;                // reason of kRefused: "other bits"
    double creatures_per_second = 0.0;  // over the last seconds
    double share = 0.0;  // share of EvaluationResult::work in the last minute, in [0, 1]
    // Creatures that were computed again elsewhere with the same bits.
    std::uint64_t checks_passed = 0;
};

// Counts since the back-end began. All except `overdue_at_home` and `poisoned` count messages and
// results that came over the network.
struct BackendCounts {
    std::uint64_t units = 0;            // units published
    std::uint64_t redelivered = 0;      // units handed out more than once
    std::uint64_t duplicates = 0;       // results for slots that already had one
    std::uint64_t overdue_at_home = 0;  // overdue units that this program's own cores computed
    std::uint64_t checked = 0;          // creatures computed again by this program
    std::uint64_t refused = 0;          // results not accepted because their worker is refused
    std::uint64_t unknown = 0;    // results of workers that did not announce themselves with proof
    std::uint64_t malformed = 0;  // messages that could not be read
    std::uint64_t poisoned = 0;   // units computed in a separate process
};

enum class ClusterLink : std::uint8_t {
    kNone,        // no cluster; only this machine evaluates
    kConnecting,  // not reached yet
    kConnected,
    kAway,  // connection lost; only this machine evaluates
};

struct BackendStatus {
    ClusterLink link = ClusterLink::kNone;
    std::string server;   // as the user entered it; empty if kNone
    std::string cluster;  // its name; empty if kNone
    std::string trouble;  // the last problem and what to do about it; empty if none
    std::string failure;  // why no run can continue with this back-end; empty while it can
    std::vector<WorkerStatus> workers;  // this program's own cores first, then by name and id
    BackendCounts counts;
    // Number of cores that the run can use; more cores would mostly wait. 0 while unknown.
    double useful_cores = 0.0;
};

// Sums over the workers that take part; absent and refused ones are left out.
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

// Returns the number of cores at which a generation spends a quarter of its time waiting. `work` is
// its evaluation in core-seconds, `overhead` its waiting in s; both must be positive.
inline double useful_cores(double work, double overhead) {
    return std::max(1.0, work / (3.0 * overhead));
}

}  // namespace cambrian
