#include "cluster/messages/proof_set.h"

#include "cluster/messages/result_text.h"
#include "core/hash.h"
#include "core/random.h"
#include "evolution/evaluation/evaluation.h"
#include "genome/founders/random_genome.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

namespace cambrian {
namespace {

constexpr std::uint64_t kProof = 1'019;  // index that keeps these founders apart from all others
constexpr double kDuration = 2.0;        // s
constexpr std::uint64_t kMostDraws = 60;
constexpr int kMovers = 5;           // moving creatures per trial of the set
constexpr double kLeastStir = 0.02;  // m; creatures that move less prove little

// Every kind of joint, sense and organ, whatever a goal allows by default.
FounderSettings all_kinds(const KindCatalog& catalog) {
    FounderSettings settings;
    for (const JointChoice& joint : catalog.joints)
        settings.joints[joint.id] = true;
    for (const ChannelEntry& channel : catalog.channels)
        settings.channels[channel.id] = true;
    for (const OrganEntry& organ : catalog.organs)
        settings.organs[organ.id] = true;
    return settings;
}

EvaluationResult judged(std::uint64_t number, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds) {
    RandomStream random(stream_seed({kProof, number}));
    auto genome = std::make_shared<const Genome>(
        random_genome(all_kinds(kinds.creature.catalog), kinds.creature.catalog, random));
    return evaluate({.genome = std::move(genome)}, settings, kinds);
}

// Returns the digest of founders, in order of their numbers, until enough of them have moved.
std::uint64_t digest_of(std::uint64_t first, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds) {
    Hash64 hash;
    int movers = 0;
    for (std::uint64_t number = first; number < first + kMostDraws && movers < kMovers; ++number) {
        const EvaluationResult result = judged(number, settings, kinds);
        hash.add(result_text(result));
        if (result.outcome == Outcome::kCompleted && result.behavior.stir > kLeastStir) ++movers;
    }
    return hash.value();
}

}  // namespace

std::vector<ProofTrial> proof_trials(const EvolutionKinds& kinds) {
    std::vector<ProofTrial> trials;
    const std::string& accurate = kinds.creature.scene.accurate_integrator;
    std::uint64_t first = 0;
    for (const GoalKind& goal : kinds.goals.all()) {
        for (const std::string& integrator : {SceneSettings{}.integrator, accurate}) {
            ExperimentSettings settings;
            settings.goal = goal.id;
            settings.world.environment = goal.default_environment();
            settings.world.scene.integrator = integrator;
            settings.world.trial.duration = kDuration;
            trials.push_back(
                {fmt::format("{}, {}", goal.id, integrator), digest_of(first, settings, kinds)});
            first += kMostDraws;
        }
    }
    return trials;
}

std::uint64_t proof_of(std::span<const ProofTrial> trials) {
    Hash64 hash;
    for (const ProofTrial& trial : trials) {
        hash.add(trial.name);
        hash.add(trial.digest);
    }
    return hash.value();
}

std::string differing_trials(std::span<const ProofTrial> expected,
                             std::span<const ProofTrial> found) {
    std::string names;
    for (const ProofTrial& trial : expected) {
        if (std::find(found.begin(), found.end(), trial) != found.end()) continue;
        if (!names.empty()) names += "; ";
        names += trial.name;
    }
    return names;
}

}  // namespace cambrian
