#pragma once

#include "evolution/evaluation/backend_status.h"
#include "evolution/evaluation/evaluation.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>

namespace cambrian {

// Progress of a batch; any thread may read it at any time.
struct EvaluationProgress {
    std::atomic<std::uint32_t> done = 0;
    std::atomic<std::uint32_t> total = 0;
};

// Evaluates batches of creatures: on this machine's cores, in other processes or on other machines.
class EvaluationBackend {
public:
    virtual ~EvaluationBackend() = default;
    // results[i] belongs to requests[i]; results that exist are not computed again. Returns false
    // if it was stopped before the batch was complete; a repeated call finishes it. Without a stop
    // request it returns false only if status().failure says why.
    virtual bool evaluate(std::span<const EvaluationRequest> requests,
                          std::span<std::optional<EvaluationResult>> results,
                          const ExperimentSettings& settings, EvaluationProgress& progress,
                          std::stop_token stop) = 0;
    // The state of the machines that evaluate. Any thread may call it; it never waits for an
    // evaluation.
    virtual BackendStatus status() const { return {}; }
};

}  // namespace cambrian
