// Contests for a cube: their score, their sides and their opponents.
#include "evolution/evaluation/trials.h"
#include "evolution/settings/goal_defaults.h"
#include "goals/contest_score.h"
#include "persist/creature/creature_file.h"
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/cheaters.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

using namespace cambrian;
using test::kinds;

namespace {

ExperimentSettings contest(const std::vector<GenomePtr>& opponents) {
    ExperimentSettings settings;
    settings.goal = "competition";
    adopt_defaults(settings, *kinds().goals.find("competition"));
    settings.world.trial.trials = std::max(1, static_cast<int>(opponents.size()));
    settings.world.opponents.genomes = opponents;
    return settings;
}

double contest_result(const GenomePtr& creature, const std::vector<GenomePtr>& opponents) {
    const ExperimentSettings settings = contest(opponents);
    const EvaluationResult result = evaluate_in_trials(
        {.genome = creature, .trial_seed = trial_seed(settings)}, settings, kinds());
    INFO(result.reason);
    REQUIRE(result.outcome == Outcome::kCompleted);
    return result.fitness;
}

GenomePtr sample(const std::string& name) {
    const std::filesystem::path folder = CAMBRIAN_SOURCE_DIR "/assets/creatures";
    const auto document = load_creature(folder / (name + ".creature.json"), kinds());
    REQUIRE(document);
    return document->creature.individual->genome;
}

// An evolved walker that goes to the right at about 1.5 m/s.
GenomePtr pusher() {
    return sample("biped");
}

// A bar that an arm of two links behind it pushes to the right at about 0.4 m/s. A careful one
// stops once the front of the bar has touched something.
GenomePtr punter(bool careful) {
    using Builder = test::CreatureBuilder;
    const KindCatalog& catalog = kinds().creature.catalog;
    Builder builder(catalog);
    const auto bar = builder.part(0.8, 0.24, "rigid");
    const auto upper = builder.part(0.43, 0.24);
    const auto lower = builder.part(0.49, 0.24);
    builder.attach(bar, upper, 0.63, -0.65);
    builder.attach(upper, lower, 0.125, 1.35);
    const InputGene front{{.kind = SourceKind::kLocalSensor,
                           .index = Builder::index_of(catalog.channels, "contact-distal")}};
    builder.neuron(bar, "memory", {Builder::constant(careful ? 1.0 : 0.0), front});
    const auto push = [&](std::uint8_t link, double phase, double amplitude) {
        const InputGene of_parent{{.kind = SourceKind::kParentNeuron, .index = 0}};
        const auto stops = builder.neuron(
            link, "sum", {of_parent, Builder::constant(0.0), Builder::constant(0.0)});
        const auto wave = builder.neuron(link, "oscillate-wave",
                                         {Builder::constant(2.0), Builder::constant(phase)});
        builder.drive(
            link,
            builder.neuron(link, "if",
                           {Builder::from(stops), Builder::constant(0.0), Builder::from(wave)}),
            amplitude);
        builder.limits(link, -test::kHalfPi, test::kHalfPi);
    };
    push(upper, 0.0, 0.95);
    push(lower, 0.4, 0.95);
    return builder.build();
}

// A box on the ground whose lid trembles a little.
GenomePtr sitter() {
    test::CreatureBuilder builder(kinds().creature.catalog);
    const auto body = builder.part(0.6, 0.4);
    const auto lid = builder.part(0.2, 0.2);
    builder.attach(body, lid, 0.375);
    builder.swing(lid, 0.2, 0.0, 0.05);
    return builder.build();
}

TrialRecord bout(const GenomePtr& creature, const GenomePtr& opponent) {
    const ExperimentSettings settings = contest({opponent});
    auto record =
        run_trial(std::make_shared<const Phenotype>(express(
                      *creature, kinds().creature, settings.expression, settings.world.scene)),
                  kinds().creature, first_trial_world(settings));
    REQUIRE(record);
    REQUIRE(record->bout);
    return *record;
}

}  // namespace

TEST_CASE("a pusher that stops at the cube beats a sitter, and one that goes on does not",
          "[goals][competition]") {
    CHECK(contest_result(punter(true), {sitter()}) >= 1.5);
    CHECK(contest_result(sitter(), {punter(true)}) <= 0.5);
    CHECK(contest_result(punter(false), {sitter()}) < 1.3);
}

TEST_CASE("the sample of a contestant takes the cube from a sitter and from a walker",
          "[goals][competition]") {
    const GenomePtr contestant = sample("porter");
    CHECK(contest_result(contestant, {sitter()}) >= 1.5);
    CHECK(contest_result(contestant, {pusher()}) >= 1.4);
}

TEST_CASE("whoever sits draws against whoever sits, whatever their shapes",
          "[goals][competition]") {
    const KindCatalog& catalog = kinds().creature.catalog;
    const std::vector<GenomePtr> sitters = {sitter(), test::still_plate(catalog),
                                            test::still_tower(catalog)};
    for (const GenomePtr& one : sitters) {
        for (const GenomePtr& other : sitters) {
            CHECK(contest_result(one, {other}) == Approx(1.0).margin(2e-3));
        }
    }
    const BoutDistances alike = *bout(sitter(), sitter()).bout;
    CHECK(alike.own > 1.3);
    CHECK(alike.own < 2.0);
    // Both start as far away as the higher one needs.
    const BoutDistances beside_tower = *bout(sitter(), test::still_tower(catalog)).bout;
    CHECK(beside_tower.own > 2.7);
}

TEST_CASE("falling and rolling while bodies settle earn nothing in a contest",
          "[goals][competition]") {
    const GenomePtr faller = test::leaning_tower(kinds().creature.catalog);
    CHECK(contest_result(faller, {sitter()}) == Approx(1.0).margin(2e-3));
    CHECK(contest_result(sitter(), {faller}) == Approx(1.0).margin(2e-3));
}

TEST_CASE("a creature that comes beats one that lies still", "[goals][competition]") {
    const KindCatalog& catalog = kinds().creature.catalog;
    for (const GenomePtr& still : {test::still_plate(catalog), test::still_tower(catalog)}) {
        CHECK(contest_result(punter(true), {still}) > 1.2);
        CHECK(contest_result(still, {punter(true)}) < 0.8);
    }
}

TEST_CASE("the scores of both sides of a bout add up to exactly 2", "[goals][competition]") {
    RandomStream stream(7);
    for (int i = 0; i < 10000; ++i) {
        const BoutDistances end{stream.uniform(0.0, 3.0), stream.uniform(0.0, 3.0)};
        REQUIRE(contest_score(end) + contest_score({end.other, end.own}) == 2.0);
    }
    CHECK(contest_score({0.0, 0.0}) == 1.0);
    CHECK(contest_score({0.0, 1.0}) == 2.0);
    const BoutDistances end = *bout(pusher(), sitter()).bout;
    CHECK(contest_score(end) + contest_score({end.other, end.own}) == 2.0);
}

TEST_CASE("an opponent smells its own scent as the judged creature does", "[goals][competition]") {
    using Builder = test::CreatureBuilder;
    const KindCatalog& catalog = kinds().creature.catalog;
    Builder builder(catalog);
    const auto body = builder.part(0.6, 0.3);
    const auto arm = builder.part(0.5, 0.2);
    builder.attach(body, arm, 0.625);
    const auto full = builder.neuron(
        body, "sum", {Builder::constant(1.0), Builder::constant(0.0), Builder::constant(0.0)});
    builder.organ(body, "scent", full, 1.0, 0.0);
    const InputGene smell{
        {.kind = SourceKind::kLocalSensor, .index = Builder::index_of(catalog.channels, "smell")}};
    builder.drive(
        arm, builder.neuron(arm, "sum", {smell, Builder::constant(0.0), Builder::constant(0.0)}),
        1.0);
    const GenomePtr creature = builder.build();
    const ExperimentSettings settings = contest({creature});
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*creature, kinds().creature, settings.expression, settings.world.scene));
    auto trial = Trial::start(phenotype, kinds().creature, first_trial_world(settings));
    REQUIRE(trial);
    while ((*trial)->tick()) {
    }
    const double own = (*trial)->scene().joint_coordinate(1);
    const double other = (*trial)->bout()->opponent()->joint_coordinate(1);
    CHECK(std::fabs(own) > 0.1);
    CHECK(std::fabs(other) == Approx(std::fabs(own)).epsilon(0.02));
}

TEST_CASE("a score is the mean over the opponents", "[goals][competition]") {
    const double sitting = contest_result(pusher(), {sitter()});
    const double coming = contest_result(pusher(), {pusher()});
    CHECK(coming != sitting);
    CHECK(contest_result(pusher(), {sitter(), pusher()}) ==
          Approx(0.5 * (sitting + coming)).epsilon(1e-12));
}

TEST_CASE("a creature without an opponent contends with its own start", "[goals][competition]") {
    CHECK(contest_result(sitter(), {}) == Approx(1.0).margin(0.02));
    CHECK(contest_result(pusher(), {}) > 1.2);
}

TEST_CASE("a replay of a bout that went back has the same bits", "[goals][competition]") {
    const ExperimentSettings settings = contest({pusher()});
    const auto start = [&] {
        auto trial = Trial::start(std::make_shared<const Phenotype>(express(
                                      *pusher(), kinds().creature, {}, settings.world.scene)),
                                  kinds().creature, first_trial_world(settings));
        REQUIRE(trial);
        return std::move(*trial);
    };
    const auto straight = start();
    while (straight->tick()) {
    }
    const auto replayed = start();
    // By then both are at the cube.
    for (int tick = 0; tick < 400; ++tick)
        replayed->tick();
    const Trial::State state = replayed->save();
    for (int tick = 0; tick < 100; ++tick)
        replayed->tick();
    replayed->restore(state);
    while (replayed->tick()) {
    }
    CHECK(replayed->record().digest == straight->record().digest);
    CHECK(replayed->record().bout == straight->record().bout);
}

TEST_CASE("a mirrored creature is the mirror image of the given one", "[goals][competition]") {
    const GenomePtr genome = pusher();
    const auto grow = [&](Side side) {
        return express(*genome, kinds().creature, {}, SceneSettings{}, side);
    };
    const Phenotype given = grow(Side::kGiven);
    const Phenotype mirrored = grow(Side::kMirrored);
    REQUIRE(given.parts.size() == mirrored.parts.size());
    for (std::size_t part = 0; part < given.parts.size(); ++part) {
        const Vec3 left = given.plan.parts[part].rest_pose.position;
        const Vec3 right = mirrored.plan.parts[part].rest_pose.position;
        CHECK(left.x() == Approx(-right.x()).margin(1e-12));
        CHECK(left.y() == Approx(right.y()).margin(1e-12));
        CHECK(given.parts[part].mirror.across == -mirrored.parts[part].mirror.across);
    }
}
