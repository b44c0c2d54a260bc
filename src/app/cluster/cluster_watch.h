#pragma once

// Messages about the cluster for a run without a window.

#include "evolution/evaluation/evaluation_backend.h"

#include <functional>
#include <string>
#include <string_view>
#include <thread>

namespace cambrian {

// Returns the end of the progress line: who evaluates, or "cluster away, working alone". Empty
// without a cluster.
std::string cluster_remark(const BackendStatus& status);

// Prints one line when the cluster is lost or found again, when a machine is refused, and on
// errors. It checks twice a second on its own thread throughout its lifetime.
class ClusterWatch {
public:
    // Both arguments must outlive the object. `say` is called on its thread.
    ClusterWatch(const EvaluationBackend& backend, std::function<void(std::string_view)> say);

private:
    void watch(const std::stop_token& stop);

    const EvaluationBackend& backend_;
    const std::function<void(std::string_view)> say_;
    std::jthread thread_;  // last member, so that it is joined before the others are destroyed
};

// Returns the "cluster" object of a generation's JSON line: who took part, and the counts since
// `before`.
std::string cluster_json(const BackendStatus& status, const BackendCounts& before);

}  // namespace cambrian
