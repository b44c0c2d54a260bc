// The evaluation of the same creature with different settings.
#include "evolution/evaluation/evaluation.h"

#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

using namespace cambrian;
using test::CreatureBuilder;
using test::kinds;

namespace {

EvaluationResult judge(const GenomePtr& genome, const ExperimentSettings& settings) {
    return evaluate({.genome = genome}, settings, kinds());
}

// Returns a creature with two legs in the same place.
GenomePtr crossed_legs() {
    CreatureBuilder builder(test::kind_catalog());
    const auto body = builder.part(0.8, 0.2);
    const auto one = builder.part(0.5, 0.1);
    const auto other = builder.part(0.5, 0.1);
    builder.attach(body, one, 0.6, -1.0);
    builder.attach(body, other, 0.7, 1.0);
    builder.swing(one, 1.0, 0.0, 0.5);
    return builder.build();
}

}  // namespace

TEST_CASE("overlapping bodies are rejected only if overlap is", "[evolution][evaluation]") {
    ExperimentSettings settings;
    settings.world.trial.duration = 1.0;
    CHECK(judge(crossed_legs(), settings).outcome == Outcome::kCompleted);
    CHECK(judge(test::crawler(test::kind_catalog()), settings).outcome == Outcome::kCompleted);
    settings.expression.strict_overlap = true;
    const EvaluationResult rejected = judge(crossed_legs(), settings);
    CHECK(rejected.outcome == Outcome::kRejected);
    CHECK(rejected.fitness == 0.0);
    CHECK(rejected.reason.find("overlap") != std::string::npos);
    settings.goal = "seeking";  // its scores may be negative
    CHECK(judge(crossed_legs(), settings).fitness == -1.0);
    CHECK(judge(test::crawler(test::kind_catalog()), settings).outcome == Outcome::kCompleted);
}

TEST_CASE("a brain that sets positions, speeds or torques moves a body in different ways",
          "[evolution][evaluation]") {
    ExperimentSettings settings;
    settings.world.trial.duration = 2.0;
    const EvaluationResult positions = judge(test::crawler(test::kind_catalog()), settings);
    settings.world.scene.motor_mode = "velocity";
    const EvaluationResult speeds = judge(test::crawler(test::kind_catalog()), settings);
    settings.world.scene.motor_mode = "torque";
    const EvaluationResult torques = judge(test::crawler(test::kind_catalog()), settings);
    CHECK(speeds.outcome == Outcome::kCompleted);
    CHECK(torques.outcome == Outcome::kCompleted);
    CHECK(speeds.digest != positions.digest);
    CHECK(torques.digest != positions.digest);
    CHECK(torques.digest != speeds.digest);
}

TEST_CASE("thinking twice a tick hardly changes a slow wave", "[evolution][evaluation]") {
    ExperimentSettings settings;
    settings.world.trial.duration = 2.0;
    const EvaluationResult once = judge(test::crawler(test::kind_catalog()), settings);
    settings.world.scene.brain_steps = 2;
    const EvaluationResult twice = judge(test::crawler(test::kind_catalog()), settings);
    CHECK(twice.outcome == Outcome::kCompleted);
    CHECK(twice.behavior.joint_frequency == Approx(once.behavior.joint_frequency).margin(0.5));
    CHECK(twice.body_length == Approx(once.body_length).epsilon(0.1));
}

TEST_CASE("behavior is measured: height, ground contact, joints and their frequency",
          "[evolution][evaluation]") {
    const EvaluationResult result =
        judge(test::crawler(test::kind_catalog()), ExperimentSettings{});
    CHECK(result.behavior.movable_joints == 2);
    CHECK(result.behavior.settled_height > 0.1);
    CHECK(result.behavior.settled_height < result.body_length);
    CHECK(result.behavior.contact_share > 0.5);
    CHECK(result.behavior.joint_frequency == Approx(0.7).margin(0.15));
    CHECK(result.behavior.mean_joint_frequency == Approx(0.7).margin(0.15));
    CHECK(result.behavior.travel > 0.0);
    CHECK(result.behavior.stir >= result.behavior.travel);
}
