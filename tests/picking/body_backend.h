#pragma once

// A back-end without physics: bodies are expressed and measured at rest.

#include "creature/phenotype_hash.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "support/kinds.h"

#include <functional>

namespace cambrian::test {

inline double rest_height(const Phenotype& phenotype) {
    Bounds bounds;
    for (const PlannedPart& part : phenotype.plan.parts) {
        for (const double x : {-part.half_extents.x(), part.half_extents.x()}) {
            for (const double y : {-part.half_extents.y(), part.half_extents.y()})
                bounds.add(transform(part.rest_pose, Vec3(x, y, 0.0)));
        }
    }
    return bounds.high.y() - bounds.low.y();
}

class BodyBackend final : public EvaluationBackend {
public:
    // Adjusts the result that the body alone gives.
    std::function<void(const Genome&, EvaluationResult&)> adjust = [](const Genome&,
                                                                      EvaluationResult&) {};
    int evaluations = 0;

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override {
        progress.total = static_cast<std::uint32_t>(requests.size());
        progress.done = 0;
        for (std::size_t i = 0; i < requests.size(); ++i) {
            if (stop.stop_requested()) return false;
            if (!results[i]) results[i] = measure(*requests[i].genome, settings);
            ++progress.done;
        }
        return true;
    }

private:
    EvaluationResult measure(const Genome& genome, const ExperimentSettings& settings) {
        ++evaluations;
        const Phenotype phenotype =
            express(genome, kinds().creature, settings.expression, settings.world.scene);
        EvaluationResult result;
        result.phenotype = phenotype_hash(phenotype);
        result.parts = static_cast<int>(phenotype.parts.size());
        result.mass = phenotype.mass(settings.world.environment.density);
        result.body_length = phenotype.rest_length();
        result.fitness = result.mass;
        result.behavior.settled_height = rest_height(phenotype);
        result.behavior.stir = result.body_length;
        if (!phenotype.can_move()) result.outcome = Outcome::kRejected;
        adjust(genome, result);
        return result;
    }
};

}  // namespace cambrian::test
