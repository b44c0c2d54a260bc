#pragma once

// What a run without a window says of the machines that work for it.

#include "evolution/evaluation/evaluation_backend.h"

#include <functional>
#include <string>
#include <string_view>
#include <thread>

namespace cambrian {

// Behind the numbers of the progress line: who works, or "cluster away, working alone". Empty
// without a cluster.
std::string cluster_remark(const BackendStatus& status);

// Says in one line when the cluster goes away or comes back, which machine is refused and why, and
// what goes wrong. Looks twice a second, on a thread of its own, as long as it lives.
class ClusterWatch {
public:
    // Both outlive the watch. say: called by its thread.
    ClusterWatch(const EvaluationBackend& backend, std::function<void(std::string_view)> say);

private:
    void watch(const std::stop_token& stop);

    const EvaluationBackend& backend_;
    const std::function<void(std::string_view)> say_;
    std::jthread thread_;  // last: uses everything above
};

// The object "cluster" of a generation's JSON line: who took part, and the counts since `before`.
std::string cluster_json(const BackendStatus& status, const BackendCounts& before);

}  // namespace cambrian
