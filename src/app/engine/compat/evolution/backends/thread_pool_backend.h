#pragma once

// The back-end where there are no threads: it evaluates one creature after the other.

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/evaluation/trials.h"

#include <cstddef>
#include <memory>

namespace cambrian {

class SerialBackend final : public EvaluationBackend {
public:
    explicit SerialBackend(const EvolutionKinds& kinds) : kinds_(&kinds) {}

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override {
        progress.total = static_cast<std::uint32_t>(requests.size());
        for (std::size_t i = 0; i < requests.size(); ++i) {
            if (!results[i]) results[i] = evaluate_in_trials(requests[i], settings, *kinds_, stop);
            ++progress.done;
        }
        return true;
    }

private:
    const EvolutionKinds* kinds_;
};

inline std::unique_ptr<EvaluationBackend> make_thread_pool_backend(const EvolutionKinds& kinds,
                                                                   std::size_t /*workers*/) {
    return std::make_unique<SerialBackend>(kinds);
}

}  // namespace cambrian
