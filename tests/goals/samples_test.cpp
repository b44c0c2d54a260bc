// The evolved samples do what their goals ask for, and earn it by their muscles.
#include "core/sample_statistics.h"
#include "creature/creature.h"
#include "creature/placement.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/evaluation/trials.h"
#include "genome/founders/random_genome.h"
#include "math/angle.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "simulator/surroundings/trial_surroundings.h"
#include "support/body_plans.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/slope_twins.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace cambrian;

namespace {

struct Sample {
    std::string name;
    GenomePtr genome;
    ExperimentSettings settings;
};

std::vector<Sample> samples_of(const std::string& goal) {
    std::vector<Sample> samples;
    for (const auto& file :
         std::filesystem::directory_iterator(CAMBRIAN_SOURCE_DIR "/assets/creatures")) {
        const auto document = load_creature(file.path(), test::kinds());
        REQUIRE(document);
        if (document->settings().goal != goal) continue;
        samples.push_back({file.path().filename().string(), document->creature.individual->genome,
                           document->settings()});
    }
    std::sort(samples.begin(), samples.end(),
              [](const Sample& a, const Sample& b) { return a.name < b.name; });
    return samples;
}

double score_of(const GenomePtr& genome, const ExperimentSettings& settings) {
    return evaluate_in_trials({.genome = genome, .trial_seed = trial_seed(settings)}, settings,
                              test::kinds())
        .fitness;
}

double turned_score(const Sample& sample, double angle) {
    Genome genome = *sample.genome;
    genome.root_angle = wrap_angle(genome.root_angle + angle);
    return score_of(std::make_shared<const Genome>(std::move(genome)), sample.settings);
}

}  // namespace

TEST_CASE("a swimmer's score does not depend on where it heads at first", "[goals][samples]") {
    const auto swimmers = samples_of("swimming");
    CHECK(swimmers.size() >= 6);
    for (const Sample& swimmer : swimmers) {
        const double score = turned_score(swimmer, 0.0);
        for (const double angle : {0.3, 0.8, 1.4, 2.5, -1.1}) {
            CAPTURE(swimmer.name, angle);
            CHECK(turned_score(swimmer, angle) == Approx(score).epsilon(0.01));
        }
    }
}

TEST_CASE("samples walk on ground that slopes a little, up and down", "[goals][samples]") {
    for (const char* goal : {"walking", "jumping"}) {
        const auto samples = samples_of(goal);
        CHECK(samples.size() >= 3);
        for (const Sample& sample : samples) {
            CAPTURE(sample.name);
            const double level = score_of(sample.genome, sample.settings);
            const auto scores = scores_in(probes_of(sample.settings, 0, 11), sample.genome,
                                          sample.settings, test::kinds());
            CHECK(median(scores) > 0.7 * level);
            CHECK(*std::min_element(scores.begin(), scores.end()) > 0.4 * level);
        }
    }
}

// For a body of many parts on the ground, forces of contact may not be found exactly (Worm).
TEST_CASE("samples walk on a slope as on flat ground under gravity that is turned",
          "[goals][samples]") {
    int same = 0;
    double degrees = -15.0;
    for (const Sample& sample : samples_of("walking")) {
        if (!sample.settings.world.environment.terrain.is_flat()) continue;
        const SceneSettings settings = with_even_steps(sample.settings.world.scene);
        const Phenotype body =
            express(*sample.genome, test::creature_kinds(), sample.settings.expression, settings);
        const SlopeTwins twins(test::creature_kinds().scene, body.plan, degrees, settings);
        Creature level(body, test::creature_kinds(), settings);
        Creature slope(body, test::creature_kinds(), settings);
        const TrialSurroundings around(Environment{}, {});
        double apart = 0.0;
        for (int tick = 0; tick < 60; ++tick) {
            level.act(*twins.both()[0], around, kTestTick);
            slope.act(*twins.both()[1], around, kTestTick);
            for (PhysicsScene* each : twins.both())
                REQUIRE(run(*each, kTestTick));
            apart = std::max(apart, twins.apart());
        }
        CAPTURE(sample.name, degrees, apart);
        same += apart < 1e-6 ? 1 : 0;
        degrees += 3.5;
    }
    CHECK(same >= 8);
}

TEST_CASE("on no slope a sample keeps a twentieth of its score without muscles",
          "[goals][samples]") {
    for (const char* goal : {"walking", "jumping"}) {
        for (Sample& sample : samples_of(goal)) {
            const double honest = score_of(sample.genome, sample.settings);
            sample.settings.world.scene.muscle_strength = 0.0;
            for (const double slope : {-15.0, -8.0, -2.0, 0.0, 2.0, 8.0, 15.0}) {
                CAPTURE(sample.name, slope);
                sample.settings.world.environment.gravity_direction = -90.0 + slope;
                CHECK(score_of(sample.genome, sample.settings) < 0.05 * honest);
            }
        }
    }
}

TEST_CASE("samples in space score what their files tell, by their muscles", "[goals][samples]") {
    int found = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(CAMBRIAN_SOURCE_DIR "/assets/creatures-3d")) {
        const auto document = load_creature(file.path(), test::spatial_kinds());
        CAPTURE(file.path().filename().string());
        REQUIRE(document);
        ExperimentSettings settings = document->settings();
        const auto score = [&] {
            return evaluate_in_trials({.genome = document->creature.individual->genome,
                                       .trial_seed = trial_seed(settings)},
                                      settings, test::spatial_kinds())
                .fitness;
        };
        const double honest = score();
        CHECK(honest == Approx(document->score()).epsilon(0.05));
        settings.world.scene.muscle_strength = 0.0;
        CHECK(score() < 0.05 * honest);
        ++found;
    }
    CHECK(found >= 9);
}

TEST_CASE("in no world of ground random creatures score without muscles", "[goals][samples]") {
    RandomStream stream(stream_seed({58, 4}));
    for (const char* goal : {"walking", "jumping"}) {
        ExperimentSettings settings;
        settings.goal = goal;
        settings.world.scene.muscle_strength = 0.0;
        for (int i = 0; i < 60; ++i) {
            Environment& world = settings.world.environment;
            world.gravity_direction = -90.0 + stream.uniform(-15.0, 15.0);
            world.gravity = stream.uniform(1.0, 20.0);
            world.friction = stream.uniform(0.1, 1.5);
            world.elasticity = stream.uniform(0.0, 0.6);
            const auto genome = std::make_shared<const Genome>(
                random_genome(settings.founders, test::kinds().creature.catalog, stream));
            CAPTURE(goal, world.gravity_direction, world.gravity, world.friction);
            CHECK(score_of(genome, settings) < 0.02);
        }
    }
}

TEST_CASE("samples seek the light on ways that no generation saw, and not in the dark",
          "[goals][samples]") {
    const auto seekers = samples_of("seeking");
    CHECK(seekers.size() >= 4);
    for (const Sample& seeker : seekers) {
        CAPTURE(seeker.name);
        CHECK(held_out_score(seeker.genome, seeker.settings, test::kinds()) > 0.2);
        ExperimentSettings dark = seeker.settings;
        dark.world.environment.light_brightness = 0.0;
        CHECK(held_out_score(seeker.genome, dark, test::kinds()) < 0.05);
    }
}

TEST_CASE("samples fly better than any passive body", "[goals][samples]") {
    const double best_parachute = 0.5;  // goals/README.md 5
    const auto flyers = samples_of("flying");
    CHECK(flyers.size() >= 3);
    for (const Sample& flyer : flyers) {
        CAPTURE(flyer.name);
        const EvaluationResult result =
            evaluate_in_trials({.genome = flyer.genome, .trial_seed = trial_seed(flyer.settings)},
                               flyer.settings, test::kinds());
        CHECK(result.outcome == Outcome::kCompleted);
        CHECK(result.fitness > 1.5 * best_parachute);
    }
}

TEST_CASE("a walker's score in space hardly depends on the way that it faces", "[goals][samples]") {
    const EvolutionKinds& space = test::spatial_kinds();
    const ExperimentSettings settings = default_settings("walking", space);
    const auto score_at = [&](const Genome& walker, double heading) {
        Genome turned = walker;
        turn_root(turned, 0.0, heading);
        return evaluate_in_trials({.genome = std::make_shared<const Genome>(std::move(turned)),
                                   .trial_seed = trial_seed(settings)},
                                  settings, space)
            .fitness;
    };
    constexpr double depth = 0.3;
    constexpr int headings = 8;
    double change = 0.0;
    int walkers = 0;
    for (const Sample& sample : samples_of("walking")) {
        Genome walker = lifted(*sample.genome, depth);
        repair(walker, space.creature.catalog);
        const double straight = score_at(walker, 0.0);
        if (straight < 0.1) continue;  // falls over to a side that the plane has not
        double mean = 0.0;
        for (int turn = 0; turn < headings; ++turn)
            mean += score_at(walker, 0.1 + 0.7 * turn) / headings;
        INFO(sample.name << " " << straight << " facing x, " << mean << " otherwise");
        CHECK(mean == Approx(straight).epsilon(0.05));
        change += (mean - straight) / straight;
        ++walkers;
    }
    CAPTURE(change / walkers);
    CHECK(walkers >= 5);
    CHECK(std::fabs(change / walkers) < 0.02);
}
