#pragma once

// An evaluation back-end without physics. Fitness is a formula of the genome; the work can be made
// to stop after a number of evaluations.

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/evolution.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <functional>
#include <string>

namespace cambrian::test {

inline double total_length(const Genome& genome) {
    double sum = 0.0;
    for (const NodeGene& node : genome.nodes)
        sum += node.length;
    return sum;
}

class FakeBackend final : public EvaluationBackend {
public:
    std::function<double(const Genome&)> fitness = total_length;
    // Computes the fitness in a slightly different world.
    std::function<double(double fitness, const Probe&)> in_probe = [](double plain, const Probe&) {
        return plain;
    };
    // Computes the fitness under the settings of the call.
    std::function<double(double fitness, const ExperimentSettings&)> under =
        [](double plain, const ExperimentSettings&) { return plain; };
    int stop_after = -1;   // evaluations in the next call; -1 for all
    int most_a_call = -1;  // evaluations in every call; -1 for all
    std::string failure;   // reported as the reason why it cannot continue; has no other effect
    int evaluations = 0;

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override {
        progress.total = static_cast<std::uint32_t>(requests.size());
        int left = std::exchange(stop_after, -1);
        if (left < 0) left = most_a_call;
        for (std::size_t i = 0; i < requests.size(); ++i) {
            if (results[i]) continue;
            if (stop.stop_requested() || left == 0) return false;
            --left;
            EvaluationResult result;
            result.fitness = under(fitness(*requests[i].genome), settings);
            if (requests[i].probe) result.fitness = in_probe(result.fitness, *requests[i].probe);
            result.phenotype = hashes_of(*requests[i].genome, settings, kinds()).phenotype;
            results[i] = result;
            ++evaluations;
            progress.done = static_cast<std::uint32_t>(i + 1);
        }
        return true;
    }
    BackendStatus status() const override {
        BackendStatus status;
        status.failure = failure;
        return status;
    }
};

// Returns an evolution after so many generations, all of them evaluated.
inline Evolution evolved(const SettingsPtr& settings, EvaluationBackend& backend, int generations) {
    Evolution evolution(settings, kinds());
    EvaluationProgress progress;
    for (int i = 0; i < generations; ++i) {
        if (i > 0) evolution.breed();
        REQUIRE(evolution.evaluate(backend, progress, {}));
    }
    return evolution;
}

}  // namespace cambrian::test
