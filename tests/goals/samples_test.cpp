// The evolved samples of seeking and of flying do what their goals ask for.
#include "evolution/evaluation/evaluation.h"
#include "evolution/evaluation/trials.h"
#include "persist/creature/creature_file.h"
#include "support/catch.h"
#include "support/kinds.h"

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
    return samples;
}

}  // namespace

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
