// Survivors are evaluated again in slightly different worlds, which reduces the influence of
// chance.
#include "evolution/evaluation/confirmation.h"

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "evolution/individual/population_digest.h"
#include "support/catch.h"
#include "support/cheaters.h"
#include "support/fake_backend.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace cambrian;
using test::evolved;
using test::FakeBackend;
using test::kinds;

namespace {

std::shared_ptr<ExperimentSettings> of_twenty() {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 20;
    settings->seed = 5;
    return settings;
}

// Only a tenth of the score remains in another world; the rest was chance.
double luck_lost(double fitness, const Probe&) {
    return 0.1 * fitness;
}

bool tried_again(const Individual& one) {
    return !one.result.scores.empty();
}

}  // namespace

TEST_CASE("a generation's worlds differ a hair, the first is computed more finely",
          "[evolution][confirmation]") {
    const ExperimentSettings settings;
    const std::vector<Probe> probes = probes_of(settings, 3, 8);
    REQUIRE(probes.size() == 8);
    CHECK(probes == probes_of(settings, 3, 8));
    CHECK(probes != probes_of(settings, 4, 8));
    std::set<double> gravities;
    std::set<bool> uphill;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        Genome creature = *test::crawler(kinds().creature.catalog);
        const double angle = creature.root_angle;
        const ExperimentSettings world = probed_world(probes[i], settings, creature);
        CHECK(std::abs(world.world.environment.gravity / 9.81 - 1.0) <= 0.01);
        CHECK(std::abs(world.world.environment.friction / 0.8 - 1.0) <= 0.01);
        CHECK(std::abs(creature.root_angle - angle) <= 0.01);
        CHECK(world.world.scene.contact_step ==
              settings.world.scene.contact_step * (i == 0 ? 0.5 : 1.0));
        gravities.insert(world.world.environment.gravity);
        CHECK(std::abs(world.world.tilt) <= 2.0);
        uphill.insert(world.world.tilt > 0.0);
    }
    CHECK(gravities.size() == 8);
    CHECK(uphill.size() == 2);
    ExperimentSettings water;
    water.world.environment.has_ground = false;
    Genome creature = *test::crawler(kinds().creature.catalog);
    CHECK(probed_world(probes.front(), water, creature).world.tilt == 0.0);
}

TEST_CASE("ground that slopes to and fro carries nobody", "[evolution][confirmation]") {
    const ExperimentSettings settings;
    const GenomePtr wheel = test::wheel(kinds().creature.catalog);
    for (const double tilt : {-2.0, 0.5, 2.0}) {
        ExperimentSettings slope = settings;
        slope.world.tilt = tilt;
        CHECK(evaluate({.genome = wheel}, slope, kinds()).fitness < 0.02);
    }
}

TEST_CASE("a trial in another world gives another score, the same every time",
          "[evolution][confirmation]") {
    const ExperimentSettings settings;
    const GenomePtr crawler = test::crawler(kinds().creature.catalog);
    const auto score = [&](const std::optional<Probe>& probe) {
        return evaluate_in_trials(
                   {.genome = crawler, .trial_seed = trial_seed(settings), .probe = probe},
                   settings, kinds())
            .fitness;
    };
    const double plain = score(std::nullopt);
    for (const Probe& probe : probes_of(settings, 0, 2)) {
        CHECK(score(probe) != plain);
        CHECK(score(probe) == Approx(plain).epsilon(0.5));
        CHECK(score(probe) == score(probe));
    }
}

TEST_CASE("only creatures that would survive are confirmed, and the median counts",
          "[evolution][confirmation]") {
    FakeBackend backend;
    auto settings = of_twenty();
    settings->selection.confirmations = 4;
    int world = 0;
    backend.in_probe = [&](double fitness, const Probe&) {
        return fitness * (0.6 + 0.1 * (world++ % 4));
    };
    const Evolution evolution = evolved(settings, backend, 1);
    int confirmed = 0;
    for (const IndividualPtr& one : evolution.population()) {
        if (!tried_again(*one)) continue;
        ++confirmed;
        const double first = one->result.scores.front();
        CHECK(first == Approx(test::total_length(*one->genome)));
        CHECK(one->result.scores.size() == 5);
        CHECK(one->result.fitness == Approx(0.8 * first));
        CHECK(unconfirmed_score(one->result) == first);
    }
    CHECK(confirmed >= 4);
    CHECK(confirmed < 20);
    const GenerationStatistics& statistics = evolution.history().back();
    CHECK(statistics.confirmations == 4 * confirmed);
    CHECK(statistics.evaluations == backend.evaluations);
    CHECK(statistics.best_lowest == Approx(0.6 * statistics.best_highest));
}

TEST_CASE("creatures that replace those with a lucky score are confirmed too, and nobody twice",
          "[evolution][confirmation]") {
    FakeBackend backend;
    backend.in_probe = luck_lost;
    const Evolution evolution = evolved(of_twenty(), backend, 4);
    // Creatures that lost their lucky score rank last only if all were evaluated again.
    for (const IndividualPtr& one : evolution.population()) {
        if (one->result.fitness > 0.0 && one->born < evolution.generation())
            CHECK(tried_again(*one));
    }
    CHECK(tried_again(*evolution.population().front()));
}

TEST_CASE("every selection confirms all that live on", "[evolution][confirmation]") {
    for (const SelectionKind& selection : kinds().selections.all()) {
        CAPTURE(selection.id);
        FakeBackend backend;
        backend.in_probe = luck_lost;
        auto settings = of_twenty();
        settings->selection.method = selection.id;
        Evolution evolution = evolved(settings, backend, 3);
        evolution.breed();
        int living = 0;
        for (const IndividualPtr& one : evolution.population()) {
            if (!one->evaluated || !(unconfirmed_score(one->result) > 0.0)) continue;
            ++living;
            CHECK(tried_again(*one));
        }
        CHECK(living > 0);
    }
}

TEST_CASE("an interrupted confirmation is continued with the same result",
          "[evolution][confirmation]") {
    FakeBackend whole;
    whole.in_probe = luck_lost;
    const Evolution reference = evolved(of_twenty(), whole, 1);
    FakeBackend backend;
    backend.in_probe = luck_lost;
    Evolution evolution(of_twenty(), kinds());
    EvaluationProgress progress;
    int calls = 0;
    backend.most_a_call = 7;
    do {
        ++calls;
    } while (!evolution.evaluate(backend, progress, {}) && calls < 100);
    CHECK(calls > 4);
    CHECK(calls < 100);
    CHECK(backend.evaluations == whole.evaluations);
    CHECK(population_digest(evolution.population()) == population_digest(reference.population()));
    CHECK(evolution.history().back().confirmations == reference.history().back().confirmations);
}

TEST_CASE("the champion is the best of the survivors in ten more worlds",
          "[evolution][confirmation]") {
    FakeBackend backend;
    EvaluationProgress progress;
    const Evolution evolution = evolved(of_twenty(), backend, 2);
    const IndividualPtr best = evolution.population().front();
    // The best creature's score is halved in the other worlds.
    backend.in_probe = [&](double fitness, const Probe&) {
        return fitness == best->result.fitness ? 0.5 * fitness : fitness;
    };
    const IndividualPtr champion = *evolution.confirmed_champion(backend, progress, {});
    CHECK(champion->result.scores.size() == 11);
    CHECK(champion->uid != best->uid);
    auto without = of_twenty();
    without->selection.confirmations = 0;
    const Evolution plain = evolved(without, backend, 1);
    CHECK(*plain.confirmed_champion(backend, progress, {}) == plain.population().front());
    CHECK_FALSE(tried_again(*plain.population().front()));
}

TEST_CASE("the champion keeps its score in an accurate computation", "[evolution][confirmation]") {
    FakeBackend backend;
    EvaluationProgress progress;
    const Evolution evolution = evolved(of_twenty(), backend, 2);
    const double best = evolution.population().front()->result.fitness;
    const auto champion_if = [&](double share_of_best, double share_of_others) {
        backend.under = [=](double fitness, const ExperimentSettings& settings) {
            if (settings.world.scene.tolerance > 1e-6) return fitness;
            return fitness * (fitness == best ? share_of_best : share_of_others);
        };
        return (*evolution.confirmed_champion(backend, progress, {}))->result.fitness;
    };
    CHECK(champion_if(0.91, 1.0) == best);
    CHECK(champion_if(1.09, 1.0) == best);
    CHECK(champion_if(0.89, 0.91) < best);
    CHECK(champion_if(1.11, 1.0) < best);
    CHECK(champion_if(0.5, 0.5) == best);  // nobody keeps its score
}

TEST_CASE("a world in which a creature fails is worse for it than any score",
          "[evolution][confirmation]") {
    FakeBackend backend;
    auto settings = of_twenty();
    settings->goal = "seeking";
    const double least = kinds().goals.find("seeking")->least_score;
    REQUIRE(least < 0.0);
    backend.fitness = [](const Genome& genome) { return -0.01 * test::total_length(genome); };
    backend.in_probe = [&](double, const Probe&) { return least; };  // as of a trial that failed
    const Evolution evolution = evolved(settings, backend, 1);
    int confirmed = 0;
    for (const IndividualPtr& one : evolution.population()) {
        if (!tried_again(*one)) continue;
        ++confirmed;
        CHECK(one->result.fitness == least);
    }
    CHECK(confirmed > 0);
}

TEST_CASE("an audit that is interrupted names no champion", "[evolution][confirmation]") {
    FakeBackend backend;
    EvaluationProgress progress;
    const Evolution evolution = evolved(of_twenty(), backend, 1);
    std::stop_source stop;
    stop.request_stop();
    CHECK_FALSE(evolution.confirmed_champion(backend, progress, stop.get_token()));
}
