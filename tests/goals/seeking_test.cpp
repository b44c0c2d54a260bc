// Seeking scored of points that move by a script, and of creatures in mirrored trials.
#include "evolution/evaluation/trials.h"
#include "simulator/surroundings/light_source.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace cambrian;

namespace {

constexpr int kTrials = 4;

const GoalKind& seeking() {
    return *test::kinds().goals.find("seeking");
}

// The velocity of a point, in body lengths a second, at a place with the light at another.
using Script = std::function<Vec3(const Vec3& at, const Vec3& light)>;

// What the legs of one trial come to; a body length is 1 m.
std::vector<double> shares_of(const Script& script, const Environment& environment,
                              const LightDraw& draw) {
    LightSource light(environment, draw);
    TrialRecord record;
    record.body_length = 1.0;
    Vec3 at = environment.has_ground ? Vec3(0.0, 0.3, 0.0) : Vec3(Vec3::Zero());
    for (std::uint64_t tick = 0; tick < 5 * light.leg_ticks(); ++tick) {
        light.move(tick, at, 1.0);
        if (tick % light.leg_ticks() == 0) record.legs.begin(0.0, light.place() - at, 1.0);
        at += kBrainTick * script(at, light.place());
        record.legs.watch((light.place() - at).norm());
    }
    return seeking().shares(record);
}

double score_of(const Script& script, bool has_ground, std::uint64_t seed) {
    Environment environment = seeking().default_environment();
    environment.has_ground = has_ground;
    std::vector<double> shares;
    for (int trial = 0; trial < kTrials; ++trial) {
        const auto more = shares_of(script, environment, {seed, trial});
        shares.insert(shares.end(), more.begin(), more.end());
    }
    REQUIRE(shares.size() == 20);
    return seeking().score_of_shares(shares);
}

Vec3 run_to_light(const Vec3& at, const Vec3& light) {
    const Vec3 way = light - at;
    return way / std::max(way.norm(), kBrainTick);
}

ExperimentSettings seeking_settings() {
    ExperimentSettings settings;
    settings.goal = "seeking";
    settings.world.environment = seeking().default_environment();
    settings.world.trial = seeking().default_trial;
    return settings;
}

}  // namespace

TEST_CASE("running to the light at a body length a second scores nearly 1", "[goals][seeking]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        CHECK(score_of(run_to_light, false, seed) >= 0.85);
        CHECK(score_of(run_to_light, true, seed) >= 0.85);
    }
}

TEST_CASE("fleeing from the light in every leg has the least score there is", "[goals][seeking]") {
    const Script flee = [](const Vec3& at, const Vec3& light) {
        return Vec3(-20.0 * run_to_light(at, light));
    };
    CHECK(score_of(flee, false, 1) == seeking().least_score);
}

TEST_CASE("always going right costs far more than it earns", "[goals][seeking]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto right = [](const Vec3&, const Vec3&) { return Vec3(1.0, 0.0, 0.0); };
        const auto left = [](const Vec3&, const Vec3&) { return Vec3(-1.0, 0.0, 0.0); };
        CHECK(score_of(right, true, seed) <= -0.4);
        CHECK(score_of(left, true, seed) == Approx(score_of(right, true, seed)));
        CHECK(score_of(right, false, seed) < -0.2);
    }
}

TEST_CASE("standing still scores 0, walking about blindly next to nothing", "[goals][seeking]") {
    const auto still = [](const Vec3&, const Vec3&) { return Vec3(Vec3::Zero()); };
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        CHECK(score_of(still, false, seed) == 0.0);
        CHECK(score_of(still, true, seed) == 0.0);
        RandomStream stream(stream_seed({seed, 11}));
        Vec3 heading = Vec3::UnitX();
        const auto walk = [&](const Vec3&, const Vec3&) {
            heading += 0.3 * Vec3(stream.gauss(), stream.gauss(), 0.0);
            heading.normalize();
            return Vec3(0.3 * heading);
        };
        const double score = score_of(walk, false, seed);
        CHECK(score < 0.1);
        sum += score;
    }
    CHECK(std::fabs(sum / 100.0) <= 0.1);
}

TEST_CASE("passing the light pays where the leg ends, not on the way", "[goals][seeking]") {
    TrialRecord record;
    record.body_length = 1.0;
    record.legs.begin(0.0, Vec3(4.0, 0.0, 0.0), 1.0);
    record.legs.watch(0.1);
    record.legs.watch(6.0);
    CHECK(seeking().score(record).value == Approx(-0.5));
    const Score score = seeking().score(record);
    CHECK(score.terms[1].value == 1.0);
}

TEST_CASE("a body that was shorter when a leg began had a shorter way", "[goals][seeking]") {
    TrialRecord record;
    record.body_length = 2.0;
    record.legs.begin(0.0, Vec3(4.0, 0.0, 0.0), 1.0);
    record.legs.watch(0.0);
    CHECK(seeking().score(record).value == Approx(0.5));
    record.legs.begin(0.0, Vec3(8.0, 0.0, 0.0), 2.0);
    record.legs.watch(0.0);
    CHECK(seeking().score(record).value == Approx(0.5 * 0.75 + 0.5 * 0.5));
}

TEST_CASE("a trial without legs and one that begins at the light score 0", "[goals][seeking]") {
    TrialRecord record;
    record.body_length = 1.0;
    CHECK(seeking().score(record).value == 0.0);
    record.legs.begin(0.0, Vec3(0.0, 0.0, 0.0), 1.0);
    record.legs.watch(2.0);
    CHECK(seeking().score(record).value == 0.0);
}

TEST_CASE("the worse half counts twice, the middle of an odd number half of it",
          "[goals][seeking]") {
    const auto score = [](std::vector<double> shares) { return seeking().score_of_shares(shares); };
    CHECK(score({1.0, 0.0}) == Approx(0.25));
    CHECK(score({0.0, 0.3, 0.9}) == Approx(0.5 * 0.4 + 0.5 * (0.0 + 0.15) / 1.5));
    CHECK(score({0.6}) == Approx(0.6));
    CHECK(score({0.5, -0.5, 0.5, -0.5}) == Approx(-0.25));
}

// Legs of a pair may begin elsewhere than mirrored, since a creature is not: so the pair is run by
// a creature and its image.
TEST_CASE("what one habit earns in a trial it loses in the mirror image", "[goals][seeking]") {
    Environment environment = seeking().default_environment();
    environment.has_ground = true;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto step = [](const Vec3&, const Vec3&) { return Vec3(0.2, 0.0, 0.0); };
        const auto here = shares_of(step, environment, {seed, 0});
        const auto there = shares_of(step, environment, {seed, 1});
        double sum = 0.0;
        for (std::size_t leg = 0; leg < here.size(); ++leg)
            sum += here[leg] + there[leg];
        CHECK(sum == Approx(0.0).margin(1e-9));
    }
}

TEST_CASE("all trials of a creature are scored together", "[goals][seeking]") {
    ExperimentSettings settings = seeking_settings();
    const EvaluationRequest request{.genome = test::crawler(test::kinds().creature.catalog),
                                    .trial_seed = trial_seed(settings)};
    const EvaluationResult all = evaluate_in_trials(request, settings, test::kinds());
    REQUIRE(all.outcome == Outcome::kCompleted);
    CHECK(all.computed_time == Approx(100.0));
    std::vector<double> shares;
    for (int trial = 0; trial < kTrials; ++trial) {
        settings.world.light = {request.trial_seed, trial};
        const JudgedTrial one = judge_trial(request, settings, test::kinds());
        REQUIRE(one.shares.size() == 5);
        shares.insert(shares.end(), one.shares.begin(), one.shares.end());
    }
    CHECK(all.fitness == seeking().score_of_shares(shares));
}

TEST_CASE("held-out trials are others than those of any draw", "[goals][seeking]") {
    ExperimentSettings settings = seeking_settings();
    const GenomePtr genome = test::crawler(test::kinds().creature.catalog);
    const double held_out = held_out_score(genome, settings, test::kinds());
    CHECK(held_out == held_out_score(genome, settings, test::kinds()));
    settings.world.trial.draw = 3;
    CHECK(held_out == held_out_score(genome, settings, test::kinds()));
    settings.world.trial.trials = 8;
    for (int draw = 0; draw < 4; ++draw) {
        settings.world.trial.draw = draw;
        const EvaluationRequest request{.genome = genome, .trial_seed = trial_seed(settings)};
        CHECK(evaluate_in_trials(request, settings, test::kinds()).fitness != held_out);
    }
}
