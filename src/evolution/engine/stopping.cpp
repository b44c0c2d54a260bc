#include "evolution/engine/stopping.h"

#include <cstdint>

namespace cambrian {

std::string_view stop_reason(std::span<const GenerationStatistics> history,
                             const ExperimentSettings& settings) {
    if (history.empty()) return {};
    if (settings.target_fitness > 0.0 && history.back().best >= settings.target_fitness)
        return "target-fitness";
    std::int64_t evaluations = 0;
    for (const GenerationStatistics& generation : history)
        evaluations += generation.evaluations;
    if (evaluations >= settings.max_evaluations) return "evaluations";
    if (history.size() >= static_cast<std::size_t>(settings.generations)) return "generations";
    return {};
}

}  // namespace cambrian
