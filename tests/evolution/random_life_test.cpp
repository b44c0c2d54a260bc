// Random genomes are mutated, bred, expressed and simulated for a second. A few are tested by
// default; the environment variable CAMBRIAN_RANDOM_GENOMES=100000 sets the number, for example
// before a release.
#include "breeding/mutation.h"
#include "core/threads/thread_pool.h"
#include "genome/founders/random_genome.h"
#include "simulator/trial.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <string>

using namespace cambrian;
using test::kinds;

namespace {

constexpr std::size_t kUsually = test::by_build(400, 100);
constexpr int kRounds = 10;  // rounds of mutation, before and after breeding

std::size_t wanted_count() {
    // Read before any thread starts.
    const char* text = std::getenv("CAMBRIAN_RANDOM_GENOMES");  // NOLINT(concurrency-mt-unsafe)
    return text == nullptr ? kUsually : std::strtoul(text, nullptr, 10);
}

// Settings with all kinds of joints, and with small and large bodies.
const FounderSettings& any_founders() {
    static const FounderSettings settings = [] {
        FounderSettings made;
        made.max_nodes = 16;
        made.max_brain_neurons = 6;
        for (const JointChoice& joint : kinds().creature.catalog.joints)
            made.joints[joint.id] = true;
        return made;
    }();
    return settings;
}

void mutate_often(Genome& genome, RandomStream& stream) {
    for (int round = 0; round < kRounds; ++round) {
        mutate(genome, {}, kinds().mutations,
               {.catalog = kinds().creature.catalog, .founders = any_founders()}, stream);
    }
}

Genome descendant(std::size_t number) {
    RandomStream stream(stream_seed(77, 0, number, Purpose::kTest));
    const KindCatalog& catalog = kinds().creature.catalog;
    Genome mother = random_genome(any_founders(), catalog, stream);
    Genome father = random_genome(any_founders(), catalog, stream);
    mutate_often(mother, stream);
    mutate_often(father, stream);
    const BreedingRegistry& methods = kinds().breeding;
    const BreedingKind& method = methods[number % methods.size()];
    Genome child = method.breed(mother, father, catalog, stream);
    mutate_often(child, stream);
    return child;
}

// Returns ground, water or space in turn.
TrialWorld world_of(std::size_t number) {
    TrialWorld world;
    world.trial.duration = 1.0;
    world.trial.settle_limit = 0.0;
    if (number % 3 == 0) return world;
    world.environment = kinds().goals.find("swimming")->default_environment();
    if (number % 3 == 2) world.environment.viscosity_quadratic = 0.0;
    return world;
}

bool finite(const TrialRecord& record) {
    double sum = record.body_length + record.mass + record.reversal_rate;
    for (const MotionSample& sample : record.samples)
        sum += sample.center_of_mass.sum() + sample.bounds.low.sum() + sample.bounds.high.sum();
    const SceneAudit& audit = record.audit;
    return std::isfinite(sum + audit.motor_work + audit.energy_residual + audit.energy_scale);
}

struct Tally {
    std::atomic<std::size_t> invalid = 0;
    std::atomic<std::size_t> refused = 0;   // bodies that physics rejected
    std::atomic<std::size_t> infinite = 0;  // completed trials with a number that is not finite
    std::array<std::atomic<std::size_t>, 16> outcomes = {};
};

void live(std::size_t number, Tally& tally) {
    const Genome genome = descendant(number);
    if (!validate(genome, kinds().creature.catalog).empty()) {
        ++tally.invalid;
        return;
    }
    const TrialWorld world = world_of(number);
    const auto phenotype = std::make_shared<const Phenotype>(
        express(genome, kinds().creature, ExpressionSettings{}, world.scene));
    const auto record = run_trial(phenotype, kinds().creature, world);
    if (!record) {
        ++tally.refused;
        return;
    }
    ++tally.outcomes[static_cast<std::size_t>(record->outcome)];
    if (record->outcome == Outcome::kCompleted && !finite(*record)) ++tally.infinite;
}

}  // namespace

TEST_CASE("random genomes mutate, breed, grow and live a second without a fault",
          "[evolution][random_life]") {
    const std::size_t count = wanted_count();
    Tally tally;
    ThreadPool pool(2);
    REQUIRE(
        pool.parallel_for(count, [&](std::size_t number, std::size_t) { live(number, tally); }));
    std::string figures = std::to_string(count) + " genomes:";
    for (std::size_t i = 0; i < tally.outcomes.size(); ++i) {
        if (tally.outcomes[i] == 0) continue;
        figures += " " + std::to_string(tally.outcomes[i]) + " " +
                   std::string(outcome_name(static_cast<Outcome>(i)));
    }
    if (count != kUsually) WARN(figures);
    INFO(figures);
    CHECK(tally.invalid == 0);
    CHECK(tally.refused == 0);
    CHECK(tally.infinite == 0);
    // Guards end some trials; physics itself almost never fails.
    const std::size_t diverged = tally.outcomes[static_cast<std::size_t>(Outcome::kDiverged)];
    CHECK(1000 * diverged <= count);
}
