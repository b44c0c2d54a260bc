// Creatures that cheat. In every goal, each must score less than every honest sample of that goal,
// and each must really perform the trick that it is named after.
#include "support/cheaters.h"

#include "evolution/evaluation/evaluation.h"
#include "evolution/evaluation/trials.h"
#include "persist/creature/creature_file.h"
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <vector>

using namespace cambrian;

namespace {

const std::filesystem::path kSamples = CAMBRIAN_SOURCE_DIR "/assets/creatures";

constexpr double kSlope = 8.0;  // degrees

// Returns the goal's world, with ground that falls to the right by an angle in degrees.
ExperimentSettings world_for(const GoalKind& goal, double slope = 0.0) {
    ExperimentSettings settings;
    settings.goal = goal.id;
    settings.world.environment = goal.default_environment();
    settings.world.environment.gravity_direction += slope;
    return settings;
}

// Measures of what a creature did, independent of the goal.
struct Deed {
    double clearance = 0.0;  // m, greatest height of its lowest point
    double rise = 0.0;       // m, greatest rise of its centre of mass above the start
    double fall = 0.0;       // m, greatest fall of its centre of mass below the start
    double edge = 0.0;       // m, displacement of its rear edge
    double way = 0.0;        // m, displacement of its centre of mass from start to end
    double walked = 0.0;     // m, path length of its centre of mass
    double shaking = 0.0;    // Hz, of the joint with the highest frequency
    double settling = 0.0;   // m, displacement of its centre of mass before the test
    double growth = 0.0;     // its length in its length at rest
    double width = 0.0;      // greatest width or height of its bounds in its length
};

Deed deed_of(const GenomePtr& genome, const TrialWorld& world) {
    auto trial = Trial::start(std::make_shared<const Phenotype>(
                                  express(*genome, test::kinds().creature, {}, world.scene)),
                              test::kinds().creature, world);
    REQUIRE(trial);
    const Vec3 born = (*trial)->scene().center_of_mass();
    while ((*trial)->settling())
        (*trial)->tick();
    Deed deed;
    deed.settling = std::fabs((*trial)->scene().center_of_mass().x() - born.x());
    const Bounds first = (*trial)->scene().bounds();
    const Vec3 start = (*trial)->scene().center_of_mass();
    Vec3 before = start;
    double side = 0.0;
    while ((*trial)->tick()) {
        const Bounds bounds = (*trial)->scene().bounds();
        const Vec3 sides = bounds.high - bounds.low;
        side = std::max({side, sides.x(), sides.y()});
        const Vec3 center = (*trial)->scene().center_of_mass();
        deed.clearance = std::max(deed.clearance, bounds.low.y());
        deed.rise = std::max(deed.rise, center.y() - start.y());
        deed.fall = std::max(deed.fall, start.y() - center.y());
        deed.edge =
            std::max({deed.edge, bounds.low.x() - first.low.x(), first.high.x() - bounds.high.x()});
        deed.walked += (center - before).norm();
        before = center;
    }
    REQUIRE((*trial)->record().outcome == Outcome::kCompleted);
    deed.way = (before - start).norm();
    deed.shaking = (*trial)->record().reversal_rate;
    deed.growth = (*trial)->record().body_length / (*trial)->phenotype().rest_length();
    deed.width = side / (*trial)->record().body_length;
    return deed;
}

struct Cheater {
    const char* name;
    const char* goal;  // goal in whose world it performs its trick
    std::function<GenomePtr(const KindCatalog&)> build;
    std::function<bool(const Deed&)> plays_its_trick;
    double slope = 0.0;  // degrees, of the ground there
};

std::vector<Cheater> zoo() {
    using namespace test;
    std::vector<Cheater> zoo = {
        {"stander-up", "jumping", stander_up,
         [](const Deed& d) { return d.rise > 0.2 && d.clearance < 0.05; }},
        {"arm raiser", "jumping", arm_raiser,
         [](const Deed& d) { return d.rise > 0.02 && d.clearance < 0.05; }},
        {"slow sinker", "walking", slow_sinker, [](const Deed& d) { return d.edge > 0.3; }},
        {"rocker", "walking", rocker,
         [](const Deed& d) { return d.walked > 2.0 && d.way < 0.2 * d.walked; }},
        {"vibrator", "walking", vibrator, [](const Deed& d) { return d.shaking > 5.0; }},
        {"circler", "swimming", circler,
         [](const Deed& d) { return d.walked > 0.5 && d.way < 0.5 * d.walked; }},
        {"glider through water", "swimming", drifter, [](const Deed& d) { return d.way > 0.05; }},
        {"glider across the axes", "swimming", oblique_drifter,
         [](const Deed& d) { return d.way > 0.05 && d.width < 0.9; }},
        {"unfolder", "seeking", unfolder, [](const Deed& d) { return d.growth > 1.8; }},
        {"faller while settling", "competition", leaning_tower,
         [](const Deed& d) { return d.settling > 0.3 && d.way < 0.05; }},
        {"still plate", "competition", still_plate, [](const Deed& d) { return d.walked < 0.05; }},
        {"still tower", "competition", still_tower, [](const Deed& d) { return d.walked < 0.05; }},
        {"wheel", "walking", wheel, [](const Deed& d) { return d.way > 10.0; }, kSlope},
    };
    for (const double delay : {1.0, 2.9, 4.5, 6.0, 7.5, 9.0, 10.5, 12.0, 13.5}) {
        const auto at = [&](GenomePtr (*build)(const KindCatalog&, double)) {
            return [build, delay](const KindCatalog& catalog) { return build(catalog, delay); };
        };
        zoo.push_back({"feet puller", "jumping", at(feet_puller), [](const Deed& d) {
                           return d.clearance > 0.02 && d.rise < 0.02 && d.fall > 0.2;
                       }});
        zoo.push_back({"toppler", "walking", at(falling_tower),
                       [](const Deed& d) { return d.fall > 0.2 && d.way > 0.5; }});
        zoo.push_back({"thrower of a limb", "walking", at(limb_thrower),
                       [](const Deed& d) { return d.edge > 0.5; }});
        zoo.push_back({"roller down its own shape", "walking", at(roller),
                       [](const Deed& d) { return d.edge > 0.3; }});
    }
    return zoo;
}

double score(const GenomePtr& genome, const ExperimentSettings& settings) {
    const EvaluationResult result = evaluate_in_trials(
        {.genome = genome, .trial_seed = trial_seed(settings)}, settings, test::kinds());
    CHECK(result.outcome == Outcome::kCompleted);
    return result.fitness;
}

// Returns the lowest score of each goal's samples, each in the trial of its file.
std::map<std::string, double> least_honest_scores() {
    std::map<std::string, double> least;
    for (const auto& file : std::filesystem::directory_iterator(kSamples)) {
        const auto sample = load_creature(file.path(), test::kinds());
        REQUIRE(sample);
        REQUIRE(sample->scored());
        const double honest = score(sample->creature.individual->genome, sample->settings());
        double& place = least.try_emplace(sample->settings().goal, honest).first->second;
        place = std::min(place, honest);
    }
    return least;
}

}  // namespace

TEST_CASE("every cheater of the zoo plays its trick", "[goals][cheaters]") {
    for (const Cheater& cheater : zoo()) {
        const GoalKind& goal = *test::kinds().goals.find(cheater.goal);
        const Deed deed = deed_of(cheater.build(test::kinds().creature.catalog),
                                  world_for(goal, cheater.slope).world);
        CAPTURE(cheater.name, deed.clearance, deed.rise, deed.fall, deed.edge, deed.way,
                deed.walked, deed.shaking, deed.settling, deed.growth, deed.width);
        CHECK(cheater.plays_its_trick(deed));
    }
}

TEST_CASE("in every goal, every cheater scores far below every honest sample",
          "[goals][cheaters]") {
    const auto honest = least_honest_scores();
    for (const GoalKind& goal : test::kinds().goals.all()) {
        CAPTURE(goal.id);
        if (goal.is_contest) continue;  // its scores depend on the opponent
        REQUIRE(honest.count(goal.id) == 1);
        for (const Cheater& cheater : zoo()) {
            CAPTURE(cheater.name);
            CHECK(score(cheater.build(test::kinds().creature.catalog), world_for(goal)) <
                  0.5 * honest.at(goal.id));
        }
    }
}

TEST_CASE("no cheater scores on a slope either", "[goals][cheaters]") {
    const auto honest = least_honest_scores();
    for (const char* id : {"walking", "jumping"}) {
        const GoalKind& goal = *test::kinds().goals.find(id);
        for (const Cheater& cheater : zoo()) {
            CAPTURE(id, cheater.name);
            CHECK(score(cheater.build(test::kinds().creature.catalog), world_for(goal, kSlope)) <
                  0.5 * honest.at(id));
        }
    }
}

TEST_CASE("no cheater beats an honest contestant", "[goals][cheaters]") {
    const auto porter = load_creature(kSamples / "porter.creature.json", test::kinds());
    REQUIRE(porter);
    ExperimentSettings settings = world_for(*test::kinds().goals.find("competition"));
    settings.world.trial.has_cube = true;
    settings.world.opponents.genomes = {porter->creature.individual->genome};
    for (const Cheater& cheater : zoo()) {
        CAPTURE(cheater.name);
        CHECK(score(cheater.build(test::kinds().creature.catalog), settings) < 1.0);
    }
}
