#include "persist/creature/rescoring.h"

#include "evolution/evaluation/trials.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace cambrian {

namespace {

// Returns the last generation, up to a given one, in which all creatures were evaluated.
std::uint32_t last_judgement(const SavedExperiment& saved, std::uint32_t until) {
    std::uint32_t generation = 0;
    if (until < saved.champions.size() &&
        !saved.champions[until].settings->world.opponents.genomes.empty())
        return until;
    SettingsPtr settings = saved.settings;
    for (const NotedCommand& noted : saved.journal) {
        if (noted.generation > until) break;
        const auto* change = std::get_if<ChangeSettings>(&noted.command);
        const bool rejudged = change != nullptr
                                  ? !same_judgement(*settings, *change->settings)
                                  : std::holds_alternative<RescorePopulation>(noted.command);
        if (change != nullptr) settings = change->settings;
        if (rejudged) generation = noted.generation;
    }
    return generation;
}

}  // namespace

std::optional<std::string> other_simulator(const std::string& version) {
    const std::string_view present = simulator_version(version.starts_with("3d-") ? 3 : 2);
    if (version == present) return std::nullopt;
    return fmt::format("scored by simulator {}, this is {}", version, present);
}

std::optional<std::string> other_simulator(const CreatureDocument& document) {
    return document.scored() ? other_simulator(document.notes.simulator) : std::nullopt;
}

std::optional<std::string> other_simulator(const SavedExperiment& saved) {
    if (!saved.latest) return std::nullopt;
    const std::uint32_t since = last_judgement(saved, std::numeric_limits<std::uint32_t>::max());
    for (std::size_t i = 0; i < saved.simulators.size(); ++i) {
        const bool replaced_before =
            i + 1 < saved.simulators.size() && saved.simulators[i + 1].generation <= since;
        if (replaced_before) continue;
        if (auto other = other_simulator(saved.simulators[i].version)) return other;
    }
    return std::nullopt;
}

std::string scored_by(const SavedExperiment& saved, std::uint32_t born, std::uint32_t generation) {
    const std::uint32_t judged = std::max(born, last_judgement(saved, generation));
    if (!saved.latest || judged > saved.latest->generation)
        return std::string(simulator_version(saved.settings->world.environment.dimensions));
    std::string version;
    for (const SimulatorChange& change : saved.simulators) {
        if (change.generation <= judged) version = change.version;
    }
    return version;
}

EvaluationResult run_scored_trial(const CreatureDocument& document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop) {
    CAMBRIAN_ASSERT(document.scored(), "only a scored creature has a trial to run");
    const EvaluationRequest request{.genome = document.creature.individual->genome,
                                    .trial_seed = trial_seed(document.settings())};
    return evaluate_in_trials(request, document.settings(), kinds, stop);
}

Result<CreatureDocument> rescored(CreatureDocument document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop) {
    if (!document.scored()) return Error{"holds no score to replace"};
    const EvaluationResult result = run_scored_trial(document, kinds, stop);
    if (result.outcome == Outcome::kInterrupted) return Error{"interrupted"};
    if (result.outcome != Outcome::kCompleted) {
        return Error{fmt::format("its trial is not finished by this simulator ({}, {})",
                                 outcome_name(result.outcome), result.reason)};
    }
    // Scores in other worlds are valid only for the same motion.
    if (other_simulator(document) || document.result().digest != result.digest)
        document.notes.confirmed.reset();
    document.notes.unit = kinds.goals.find(document.settings().goal)->unit;
    document.notes.simulator = simulator_version(document.settings().world.environment.dimensions);
    document.notes.ticks.clear();
    change_individual(document.creature, [&](Individual& each) { each.result = result; });
    complete_score(document, kinds, stop);
    if (stop.stop_requested()) return Error{"interrupted"};
    return document;
}

}  // namespace cambrian
