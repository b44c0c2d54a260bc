#pragma once

#include "evolution/evaluation/backend_status.h"
#include "evolution/evaluation/evaluation.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>

namespace cambrian {

// How far a batch is; readable by any thread at any time.
struct EvaluationProgress {
    std::atomic<std::uint32_t> done = 0;
    std::atomic<std::uint32_t> total = 0;
};

// Runs a batch somewhere: this machine's cores, other processes, other machines.
class EvaluationBackend {
public:
    virtual ~EvaluationBackend() = default;
    // results[i] answers requests[i]; those already there are kept and not run again. False if
    // stopped before the batch was complete; the call may then be repeated to finish it. Without a
    // stop request it is false only if status().failure says why.
    virtual bool evaluate(std::span<const EvaluationRequest> requests,
                          std::span<std::optional<EvaluationResult>> results,
                          const ExperimentSettings& settings, EvaluationProgress& progress,
                          std::stop_token stop) = 0;
    // Who evaluates. Any thread may ask at any time and never waits for an evaluation.
    virtual BackendStatus status() const { return {}; }
};

}  // namespace cambrian
