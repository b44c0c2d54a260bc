// A trial ends early when its creature has come to rest (evolution/README.md 4, P4).
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

using namespace cambrian;
using test::CreatureBuilder;

namespace {

TrialRecord run(const GenomePtr& genome, bool stop_at_rest) {
    TrialWorld world;
    world.trial.stop_at_rest = stop_at_rest;
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*genome, test::creature_kinds(), ExpressionSettings{}, world.scene));
    auto record = run_trial(phenotype, test::creature_kinds(), world);
    REQUIRE(record);
    REQUIRE(record->outcome == Outcome::kCompleted);
    return *record;
}

// Returns a body with an arm whose effector reads one neuron.
GenomePtr listener(const std::string& function, const std::vector<double>& inputs, double weight) {
    CreatureBuilder builder(test::creature_kinds().catalog);
    const auto body = builder.part(0.6, 0.2);
    const auto arm = builder.part(0.3, 0.1);
    builder.attach(body, arm, 0.1);
    std::vector<InputGene> genes;
    for (const double input : inputs)
        genes.push_back(CreatureBuilder::constant(input));
    builder.drive(arm, builder.neuron(arm, function, genes), weight);
    return builder.build();
}

void check_same_motion(const TrialRecord& a, const TrialRecord& b) {
    REQUIRE(a.samples.size() == b.samples.size());
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
        CHECK(a.samples[i].time == b.samples[i].time);
        CHECK((a.samples[i].center_of_mass - b.samples[i].center_of_mass).norm() < 1e-3);
        CHECK((a.samples[i].bounds.low - b.samples[i].bounds.low).norm() < 1e-3);
        CHECK((a.samples[i].bounds.high - b.samples[i].bounds.high).norm() < 1e-3);
    }
}

}  // namespace

TEST_CASE("what lies still is recorded to the end and computed for a few seconds only",
          "[simulator][rest]") {
    const TrialRecord full = run(test::dreamer(test::creature_kinds().catalog), false);
    const TrialRecord stopped = run(test::dreamer(test::creature_kinds().catalog), true);
    CHECK(full.computed_time == Approx(15.0));
    CHECK(stopped.computed_time >= 2.0);
    CHECK(stopped.computed_time < 5.0);
    check_same_motion(full, stopped);
}

TEST_CASE("one move and then rest gives the motion of the complete trial", "[simulator][rest]") {
    for (const GenomePtr& genome :
         {listener("smooth", {1.0, 0.5}, 0.8), listener("integrate", {0.0}, 1.0),
          listener("oscillate-wave", {0.0, 0.25}, 0.7)}) {
        const TrialRecord full = run(genome, false);
        const TrialRecord stopped = run(genome, true);
        CHECK(stopped.computed_time < 12.0);
        check_same_motion(full, stopped);
        CHECK(full.reversal_rate == stopped.reversal_rate);
    }
}

TEST_CASE("a brain that has not made up its mind keeps the trial going", "[simulator][rest]") {
    // The first creature has a clock of 40 s and falls after 9 s at rest; the second has a signal
    // that rises slowly.
    CHECK(run(test::falling_tower(test::creature_kinds().catalog, 9.0), true).computed_time ==
          Approx(15.0));
    CHECK(run(listener("oscillate-saw", {1e-5, 0.0}, 0.0), true).computed_time == Approx(15.0));
    CHECK(run(listener("integrate", {0.01}, 0.0), true).computed_time == Approx(15.0));
}
