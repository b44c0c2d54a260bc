#include "creature/phenotype_hash.h"

#include "breeding/mutation.h"
#include "evolution/evaluation/evaluation.h"
#include "genome/founders/random_genome.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <functional>

using namespace cambrian;
using test::kinds;

namespace {

Genome genome_of(std::uint64_t seed) {
    RandomStream stream(seed);
    return random_genome(FounderSettings{}, kinds().creature.catalog, stream);
}

Phenotype grown(const Genome& genome) {
    return express(genome, kinds().creature, ExpressionSettings{}, SceneSettings{});
}

Phenotype moving() {
    for (std::uint64_t seed = 1;; ++seed) {
        Phenotype phenotype = grown(genome_of(seed));
        if (phenotype.has_live_control && !phenotype.network.order.empty() &&
            !phenotype.sensors.empty())
            return phenotype;
    }
}

}  // namespace

TEST_CASE("the phenotype's hash is over all that a trial depends on", "[creature]") {
    const Phenotype phenotype = moving();
    const std::uint64_t hash = phenotype_hash(phenotype);
    CHECK(phenotype_hash(moving()) == hash);
    const std::vector<std::function<void(Phenotype&)>> changes = {
        [](Phenotype& p) { p.plan.parts.back().half_extents.x() += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().rest_pose.position.y() += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().rest_pose.orientation.z() += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().rest_angle += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().parent = -1; },
        [](Phenotype& p) { p.plan.parts.back().motion = JointMotion::kSlide; },
        [](Phenotype& p) { p.plan.parts.back().anchor_in_parent.x() += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().anchor_in_child.x() += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().limit_low -= 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().limit_high += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().max_effort += 1e-9; },
        [](Phenotype& p) { p.plan.parts.back().motor_mode = MotorMode::kTorque; },
        [](Phenotype& p) { ++p.sensors.back().part; },
        [](Phenotype& p) { ++p.sensors.back().kind; },
        [](Phenotype& p) { ++p.sensors.back().channel; },
        [](Phenotype& p) { p.sensors.back().mirror.across = -p.sensors.back().mirror.across; },
        [](Phenotype& p) { p.sensors.back().scale += 1e-9; },
        [](Phenotype& p) { ++p.network.neurons[p.network.order.back()].function; },
        [](Phenotype& p) { p.network.neurons[p.network.order.back()].inputs[0].weight += 1e-9; },
        [](Phenotype& p) { p.network.outputs.back().weight += 1e-9; },
        [](Phenotype& p) { p.network.outputs.back().slot = p.network.zero_slot(); },
        [](Phenotype& p) { ++p.effectors.back().part; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        CAPTURE(i);
        Phenotype changed = phenotype;
        changes[i](changed);
        CHECK(phenotype_hash(changed) != hash);
    }
}

TEST_CASE("a neuron that nobody hears leaves the phenotype's hash as it was", "[creature]") {
    Genome genome = genome_of(3);
    const std::uint64_t before = phenotype_hash(grown(genome));
    NeuronGene mute;
    mute.inputs.resize(static_cast<std::size_t>(kinds().creature.functions[0].arity));
    genome.brain.insert(genome.brain.end(), mute);
    Phenotype phenotype = grown(genome);
    const bool heard = std::any_of(
        phenotype.network.order.begin(), phenotype.network.order.end(),
        [&](std::uint32_t neuron) { return neuron == phenotype.network.neurons.size() - 1; });
    REQUIRE_FALSE(heard);
    CHECK(phenotype_hash(phenotype) == before);
}

TEST_CASE("children with their parent's phenotype hash move as it does", "[creature][evolution]") {
    ExperimentSettings settings;
    settings.goal = "walking";
    settings.world.trial.duration = 1.0;
    int same = 0;
    int changed = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        const auto parent = std::make_shared<const Genome>(genome_of(seed));
        const std::uint64_t hash = hashes_of(*parent, settings, kinds()).phenotype;
        const EvaluationResult judged = evaluate({.genome = parent}, settings, kinds());
        CHECK(judged.phenotype == hash);
        for (std::uint64_t child = 0; child < 4; ++child) {
            Genome mutant = *parent;
            RandomStream stream(1000 * seed + child);
            mutate(mutant, settings.mutation, kinds().mutations,
                   {.catalog = kinds().creature.catalog, .founders = settings.founders}, stream);
            if (mutant == *parent) continue;
            if (hashes_of(mutant, settings, kinds()).phenotype != hash) {
                ++changed;
                continue;
            }
            ++same;
            const EvaluationResult twin =
                evaluate({.genome = std::make_shared<const Genome>(mutant)}, settings, kinds());
            CHECK(twin.digest == judged.digest);
            CHECK(twin.fitness == judged.fitness);
            CHECK(twin.parts == judged.parts);
            CHECK(twin.neurons == judged.neurons);
        }
    }
    CHECK(same > 50);
    CHECK(changed > 100);
}
