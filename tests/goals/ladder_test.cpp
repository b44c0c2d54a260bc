// The ladders of goals/README.md 1 to 3: imitations of the behaviour must score low, real progress
// high.
#include "evolution/evaluation/evaluation.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <cmath>

using namespace cambrian;

namespace {

EvaluationResult walk(const GenomePtr& genome) {
    return evaluate({.genome = genome}, ExperimentSettings{}, test::kinds());
}

// Evaluates in the goal's default world.
EvaluationResult attempt(const char* goal, const GenomePtr& genome) {
    ExperimentSettings settings;
    settings.goal = goal;
    settings.world.environment = test::kinds().goals.find(goal)->default_environment();
    return evaluate({.genome = genome}, settings, test::kinds());
}

const KindCatalog& catalog() {
    return test::kinds().creature.catalog;
}

}  // namespace

TEST_CASE("a rigid tower and a creature without live control score nothing", "[goals][ladder]") {
    CHECK(walk(test::rigid_tower(catalog())).outcome == Outcome::kRejected);
    CHECK(walk(test::rigid_tower(catalog())).fitness == 0.0);
    CHECK(walk(test::dreamer(catalog())).outcome == Outcome::kRejected);
}

TEST_CASE("a tower that tips itself over scores below 0.02, whenever it falls", "[goals][ladder]") {
    for (const double delay : {0.1, 6.0, 9.0}) {
        const EvaluationResult result = walk(test::falling_tower(catalog(), delay));
        CAPTURE(delay);
        CHECK(result.outcome == Outcome::kCompleted);
        CHECK(result.body_length > 2.0);
        CHECK(result.fitness < 0.02);
    }
}

TEST_CASE("a body with two sine-driven legs crawls", "[goals][ladder]") {
    const EvaluationResult result = walk(test::crawler(catalog()));
    CHECK(result.outcome == Outcome::kCompleted);
    CHECK(result.fitness > 0.02);
}

TEST_CASE("a creature that kicks itself off once scores below 0.05 in walking", "[goals][ladder]") {
    for (const double delay : {4.0, 8.0, 12.0}) {
        const EvaluationResult result = walk(test::kicker(catalog(), delay));
        CAPTURE(delay);
        CHECK(result.outcome == Outcome::kCompleted);
        CHECK(result.fitness < 0.05);
    }
}

// The body is twice as large with everything in proportion (Froude scaling): times are longer and
// joint speeds lower by the square root of two, muscles are stronger with the weight.
TEST_CASE("walking is scored alike at another scale", "[goals][ladder]") {
    const double root = std::sqrt(2.0);
    const EvaluationResult small = walk(test::crawler(catalog()));
    Genome large = *test::crawler(catalog());
    for (NodeGene& node : large.nodes) {
        node.length *= 2.0;
        node.width *= 2.0;
        for (NeuronGene& neuron : node.neurons)
            neuron.inputs[0].weight /= root;  // the oscillators' frequency
    }
    ExperimentSettings slower;
    slower.world.trial.duration *= root;
    slower.world.trial.settle_limit *= root;
    slower.world.scene.muscle_strength *= 2.0;
    slower.world.scene.target_smoothing *= root;
    slower.world.scene.motor_speed_limit /= root;
    slower.world.scene.motor_frequency /= root;
    const EvaluationResult result =
        evaluate({.genome = std::make_shared<const Genome>(large)}, slower, test::kinds());
    REQUIRE(result.outcome == Outcome::kCompleted);
    CHECK(result.body_length == Approx(2.0 * small.body_length).epsilon(0.1));
    CHECK(result.fitness * root == Approx(small.fitness).epsilon(0.25));
}

TEST_CASE("raising an arm is not jumping, kicking off the Moon is", "[goals][ladder]") {
    ExperimentSettings moon;
    moon.goal = "jumping";
    moon.world.environment.gravity = 1.62;
    const auto jump = [&](const GenomePtr& genome) {
        return evaluate({.genome = genome}, moon, test::kinds());
    };
    const EvaluationResult raised = jump(test::arm_raiser(catalog()));
    CHECK(raised.outcome == Outcome::kCompleted);
    CHECK(raised.fitness > 0.0);
    CHECK(raised.fitness <= 0.1 * raised.body_length);
    CHECK(raised.behavior.contact_share > 0.9);
    const EvaluationResult kicked = jump(test::kicker(catalog(), 5.0));
    CHECK(kicked.outcome == Outcome::kCompleted);
    CHECK(kicked.fitness > 5.0 * raised.fitness);
    CHECK(jump(test::rigid_tower(catalog())).fitness == 0.0);
}

// The same body beats its wings faster and wider, so that it jumps higher, on the Moon.
TEST_CASE("standing still, raising wings, a small jump and a bigger one score in that order",
          "[goals][ladder]") {
    ExperimentSettings moon;
    moon.goal = "jumping";
    moon.world.environment.gravity = 1.62;
    const auto beat = [&](double frequency, double amplitude) {
        const EvaluationResult result = evaluate(
            {.genome = test::flapper(catalog(), frequency, amplitude)}, moon, test::kinds());
        CHECK(result.outcome == Outcome::kCompleted);
        return result;
    };
    const EvaluationResult still = beat(0.2, 0.0);
    const EvaluationResult raised = beat(0.1, 1.4);
    const EvaluationResult hop = beat(0.65, 0.7);
    const EvaluationResult leap = beat(0.65, 1.4);
    CHECK(still.fitness < 0.001);
    CHECK(raised.fitness > 0.01);
    CHECK(raised.fitness < 0.05);
    CHECK(raised.behavior.contact_share == 1.0);
    CHECK(hop.fitness > 2.0 * raised.fitness);
    CHECK(hop.behavior.contact_share < 1.0);
    CHECK(leap.fitness > 2.0 * hop.fitness);
    CHECK(leap.behavior.contact_share < hop.behavior.contact_share);
}

TEST_CASE("a beating tail swims, a single stroke hardly does", "[goals][ladder]") {
    const EvaluationResult swimmer = attempt("swimming", test::fish(catalog()));
    CHECK(swimmer.outcome == Outcome::kCompleted);
    CHECK(swimmer.fitness > 0.02);
    const EvaluationResult drifting = attempt("swimming", test::drifter(catalog()));
    CHECK(drifting.outcome == Outcome::kCompleted);
    CHECK(drifting.fitness < 0.01);
    CHECK(attempt("swimming", test::rigid_tower(catalog())).fitness == 0.0);
}
