#include "evolution/evaluation/trials.h"
#include "genome/founders/random_genome.h"
#include "simulator/passive_sink.h"
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"
#include "support/records.h"

#include <algorithm>
#include <cmath>

using namespace cambrian;
using test::CreatureBuilder;
using test::moving_box;

namespace {

const GoalKind& flying() {
    return *test::kinds().goals.find("flying");
}

ExperimentSettings flying_settings() {
    ExperimentSettings settings;
    settings.goal = "flying";
    settings.world.environment = flying().default_environment();
    return settings;
}

// A box that rises at a steady speed and moves on at another, m/s.
double steady_score(double climb, double travel, double sink = 0.27) {
    TrialRecord record =
        moving_box(15.0, 1.0, 0.1, [&](double t) { return Vec3(travel * t, climb * t, 0.0); });
    record.passive_sink = sink;
    return flying().score(record).value;
}

EvaluationResult fly(const GenomePtr& genome, const ExperimentSettings& settings) {
    const EvaluationRequest request{.genome = genome, .trial_seed = trial_seed(settings)};
    return evaluate_in_trials(request, settings, test::kinds());
}

// A plate with a stub, which stays level as it falls.
GenomePtr parachute() {
    CreatureBuilder builder(test::kinds().creature.catalog);
    const auto plate = builder.part(1.6, gene_range::kMinSize);
    const auto stub = builder.part(gene_range::kMinSize, gene_range::kMinSize);
    builder.attach(plate, stub, 0.375, 0.0);
    builder.swing(stub, 0.25, 0.0, 1e-3);
    return builder.build();
}

GenomePtr stone() {
    CreatureBuilder builder(test::kinds().creature.catalog);
    const auto block = builder.part(0.96, 0.96);
    const auto stub = builder.part(gene_range::kMinSize, gene_range::kMinSize);
    builder.attach(block, stub, 0.375, 0.0);
    builder.swing(stub, 0.25, 0.0, 1e-3);
    return builder.build();
}

// Two wings of two links each; the outer ones fold as wings rise. The numbers were tuned by trial.
GenomePtr folding_flapper() {
    constexpr double kBeat = 0.615;  // Hz
    CreatureBuilder builder(test::kinds().creature.catalog);
    const auto body = builder.part(0.6, 0.16);
    const auto link = [&](double length, double width, double amplitude, double phase,
                          double offset) {
        const auto node = builder.part(length, width);
        builder.limits(node, -1.5, 1.5);
        InputGene beat = CreatureBuilder::from(
            builder.neuron(node, "oscillate-wave",
                           {CreatureBuilder::constant(kBeat), CreatureBuilder::constant(phase)}));
        beat.weight = amplitude;
        const auto sum = builder.neuron(
            node, "sum", {beat, CreatureBuilder::constant(offset), CreatureBuilder::constant(0.0)});
        builder.drive(node, sum, 1.0);
        return node;
    };
    const auto inner = [&](double side) {
        return link(0.758, 0.149, side * 1.3, 0.0, side * -0.577);
    };
    const auto outer = [&](double side) {
        return link(0.542, 0.08, side * 1.5, 0.054, side * 0.847);
    };
    const auto right = inner(1.0);
    const auto left = inner(-1.0);
    builder.attach(body, right, 0.125);
    builder.attach(body, left, 0.625);
    builder.attach(right, outer(1.0), 0.125);
    builder.attach(left, outer(-1.0), 0.125);
    return builder.build();
}

}  // namespace

TEST_CASE("the passive sink is the speed at which drag carries the thinnest part",
          "[goals][flying]") {
    Environment air = flying().default_environment();
    const double v = passive_sink(air);
    CHECK(v == Approx(0.27).margin(0.01));
    CHECK(0.02 * v + 0.2 * v * v == Approx(0.08 * 0.25));
    air.viscosity_quadratic = 0.0;
    CHECK(passive_sink(air) == Approx(0.08 * 0.25 / 0.02));
    air.viscosity_linear = 0.0;
    CHECK(passive_sink(air) == 0.0);
    air.viscosity_linear = 1.0;
    air.gravity = 0.0;
    CHECK(passive_sink(air) == 0.0);
}

TEST_CASE("a stone, the best parachute, level flight and climbing score 0.06, 0.5, 1 and 2",
          "[goals][flying]") {
    CHECK(steady_score(-10.0, 0.0) == Approx(1.0 / 16.0));
    CHECK(steady_score(-0.27, 0.0) == Approx(0.5));
    CHECK(steady_score(0.0, 0.0) == Approx(1.0));
    CHECK(steady_score(0.27, 0.0) == Approx(2.0));
    CHECK(steady_score(5.0, 0.0) == Approx(2.0));
}

TEST_CASE("travel pays as far as a creature stays up", "[goals][flying]") {
    CHECK(steady_score(-0.27, 0.4) == Approx(0.5));
    CHECK(steady_score(-0.135, 0.4) == Approx(std::pow(2.0, -0.5) + 0.5 * 0.4));
    CHECK(steady_score(0.0, 0.4) == Approx(1.4));
    CHECK(steady_score(0.0, -0.4) == Approx(1.4));
}

TEST_CASE("without a passive sink there is no score", "[goals][flying]") {
    CHECK(steady_score(0.1, 0.0, 0.0) == 0.0);
}

TEST_CASE("from where the ground is touched on, it is the fastest fall", "[goals][flying]") {
    // Level at 1 m, and on the ground from 9 s on: in the third window of four.
    TrialRecord record =
        moving_box(15.0, 1.0, 0.1, [](double t) { return Vec3(0.0, t < 9.0 ? 1.0 : 0.05, 0.0); });
    record.passive_sink = 1.0;
    record.has_ground = true;
    const double touched = flying().score(record).value;
    record.has_ground = false;
    CHECK(touched < 0.2);
    CHECK(flying().score(record).value > 0.5);
}

TEST_CASE("a stone falls, a parachute sinks, a flapper climbs", "[goals][flying]") {
    ExperimentSettings settings = flying_settings();
    const double stone_score = fly(stone(), settings).fitness;
    const double parachute_score = fly(parachute(), settings).fitness;
    CHECK(stone_score < 0.75 * parachute_score);
    CHECK(parachute_score > 0.3);
    CHECK(parachute_score < 0.501);  // it starts from rest
    CHECK(fly(folding_flapper(), settings).fitness > 1.4);
    settings.world.scene.muscle_strength = 0.0;
    CHECK(fly(folding_flapper(), settings).fitness <= 0.5);
}

TEST_CASE("the mean lift of a flapper exceeds its weight", "[goals][flying]") {
    const ExperimentSettings settings = flying_settings();
    const Kinds& kinds = test::creature_kinds();
    const auto flapper = std::make_shared<const Phenotype>(
        express(*folding_flapper(), kinds, settings.expression, settings.world.scene));
    const auto flight = run_trial(flapper, kinds, settings.world);
    REQUIRE(flight);
    REQUIRE(flight->outcome == Outcome::kCompleted);
    // It begins at rest, so it is higher at the end only if it is carried.
    const auto& samples = flight->samples;
    CHECK(samples.back().center_of_mass.y() > samples.front().center_of_mass.y() + 1.0);
}

TEST_CASE("without muscles nothing scores above 0.5", "[goals][flying]") {
    ExperimentSettings settings = flying_settings();
    settings.world.scene.muscle_strength = 0.0;
    RandomStream stream(stream_seed({22, 73}));
    int flown = 0;
    for (int i = 0; i < 150; ++i) {
        const auto genome = std::make_shared<const Genome>(
            random_genome(settings.founders, test::kinds().creature.catalog, stream));
        const EvaluationResult result = fly(genome, settings);
        if (result.outcome != Outcome::kCompleted) continue;
        ++flown;
        CHECK(result.fitness <= 0.5);
    }
    CHECK(flown > 100);
}
