#pragma once

// A back-end whose trials are run elsewhere: by engines that evolve the same population, each of
// which evaluates some creatures and takes the results of the others. Since all of them breed from
// the same bits, results are all they exchange.

#include "core/result.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

class SharedTrials final : public EvaluationBackend {
public:
    explicit SharedTrials(const EvolutionKinds& kinds) : kinds_(&kinds) {}

    // Leaves the trials without a result here and returns false; once take() has the results of
    // all, the repeated call passes them on.
    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override;

    // Number of trials that were left here, the longest one first.
    std::size_t count() const { return requests_.size(); }
    // Runs a trial; `index` must be less than count(). Returns its result as text.
    std::string run(std::size_t index);
    // Takes the result of a trial that another engine ran; `index` must be less than count().
    Status take(std::size_t index, std::string_view result);

private:
    const EvolutionKinds* kinds_;
    const ExperimentSettings* settings_ = nullptr;
    std::vector<EvaluationRequest> requests_;
    std::vector<std::optional<EvaluationResult>> results_;
};

}  // namespace cambrian
