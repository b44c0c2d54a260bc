#include "evolution/evolution.h"

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/fields/setting_field.h"
#include "evolution/settings/goal_defaults.h"
#include "genome/founders/random_genome.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"

#include <set>

using namespace cambrian;
using test::FakeBackend;
using test::kinds;

namespace {

std::shared_ptr<ExperimentSettings> small_settings(int size = 40) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = size;
    settings->seed = 5;
    return settings;
}

void run(Evolution& evolution, EvaluationBackend& backend, int generations) {
    EvaluationProgress progress;
    for (int i = 0; i < generations; ++i) {
        if (i > 0) evolution.breed();
        REQUIRE(evolution.evaluate(backend, progress, {}));
    }
}

// Breeds two generations of simple creatures by one method only.
void check_size_is_kept(int size, const std::string& selection, const std::string& way,
                        const std::string& choice) {
    CAPTURE(size, selection, way, choice);
    auto settings = small_settings(size);
    settings->founders.max_nodes = 2;
    settings->founders.max_node_neurons = 1;
    settings->selection.method = selection;
    settings->breeding.choice = choice;
    for (const BreedingKind& kind : kinds().breeding.all())
        settings->breeding.shares[kind.id] = kind.id == way ? 1.0 : 0.0;
    REQUIRE(check_settings(*settings, kinds()));
    Evolution evolution(settings, kinds());
    FakeBackend backend;
    run(evolution, backend, 2);
    CHECK(evolution.generation() == 1);
    CHECK(evolution.population().size() >= static_cast<std::size_t>(size));
    const auto children =
        std::count_if(evolution.population().begin(), evolution.population().end(),
                      [](const IndividualPtr& one) { return one->born == 1; });
    CHECK(children > 0);
}

std::vector<std::uint64_t> hashes(const Evolution& evolution) {
    std::vector<std::uint64_t> all;
    for (const IndividualPtr& one : evolution.population())
        all.push_back(one->genome_hash);
    return all;
}

}  // namespace

TEST_CASE("under every selection the best never falls, and rises", "[evolution]") {
    for (const SelectionKind& selection : kinds().selections.all()) {
        auto settings = small_settings();
        settings->selection.method = selection.id;
        Evolution evolution(settings, kinds());
        FakeBackend backend;
        run(evolution, backend, 25);
        const auto& history = evolution.history();
        CAPTURE(selection.id);
        for (std::size_t i = 1; i < history.size(); ++i)
            CHECK(history[i].best >= history[i - 1].best);
        CHECK(history.back().best > 1.2 * history.front().best);
    }
}

TEST_CASE("the same seed gives the same generations, another seed others", "[evolution]") {
    for (const SelectionKind& selection : kinds().selections.all()) {
        auto settings = small_settings();
        settings->selection.method = selection.id;
        Evolution first(settings, kinds());
        Evolution second(settings, kinds());
        auto other_settings = std::make_shared<ExperimentSettings>(*settings);
        other_settings->seed = 6;
        Evolution other(other_settings, kinds());
        FakeBackend backend;
        for (Evolution* each : {&first, &second, &other})
            run(*each, backend, 6);
        CAPTURE(selection.id);
        CHECK(hashes(first) == hashes(second));
        CHECK(hashes(first) != hashes(other));
    }
}

TEST_CASE("a population of 2 evolves under every selection and every way of breeding",
          "[evolution]") {
    for (const SelectionKind& selection : kinds().selections.all()) {
        for (const BreedingKind& way : kinds().breeding.all()) {
            for (const char* choice : {"shares", "attribute"})
                check_size_is_kept(2, selection.id, way.id, choice);
        }
    }
}

constexpr int kLargePopulation = test::by_build(10'000, 1'000);

TEST_CASE("a large population evolves under every selection, bred in every way", "[evolution]") {
    const auto& ways = kinds().breeding.all();
    const auto& selections = kinds().selections.all();
    REQUIRE(selections.size() >= ways.size());
    for (std::size_t i = 0; i < selections.size(); ++i) {
        check_size_is_kept(kLargePopulation, selections[i].id, ways[i % ways.size()].id,
                           i % 2 == 0 ? "shares" : "attribute");
    }
}

TEST_CASE("requested random immigrants come once", "[evolution]") {
    Evolution evolution(small_settings(50), kinds());
    FakeBackend backend;
    run(evolution, backend, 1);
    const auto immigrants = [&] {
        evolution.breed();
        EvaluationProgress progress;
        REQUIRE(evolution.evaluate(backend, progress, {}));
        return std::count_if(evolution.population().begin(), evolution.population().end(),
                             [&](const IndividualPtr& one) {
                                 return one->method == "random" &&
                                        one->born == evolution.generation();
                             });
    };
    evolution.add_immigrants(0.2);
    CHECK(immigrants() == 10);
    CHECK(immigrants() == 0);
}

TEST_CASE("a run without progress is stagnant until it is evaluated again", "[evolution]") {
    auto settings = small_settings(10);
    settings->mutation.scheme = "none";
    settings->breeding.shares = {{"asexual", 1}, {"crossover", 0}, {"grafting", 0}};
    Evolution evolution(settings, kinds());
    FakeBackend backend;
    run(evolution, backend, 16);
    CHECK(stagnant(evolution.history().back()));
    auto moon = std::make_shared<ExperimentSettings>(*settings);
    moon->world.environment.gravity = 1.62;
    evolution.replace_settings(moon);
    evolution.breed();
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    CHECK_FALSE(stagnant(evolution.history().back()));
}

TEST_CASE("a child keeps its line's age while only its control changes", "[evolution]") {
    auto settings = small_settings();
    settings->breeding.shares = {{"asexual", 1}, {"crossover", 0}, {"grafting", 0}};
    for (const MutationKind& kind : kinds().mutations.all())
        settings->mutation.weights[kind.id] = kind.id == "weight" || kind.id == "root" ? 1 : 0;
    Evolution evolution(settings, kinds());
    FakeBackend backend;
    run(evolution, backend, 6);
    int kept = 0;
    int renewed = 0;
    for (const IndividualPtr& one : evolution.population()) {
        const bool new_body =
            std::any_of(one->mutations.begin(), one->mutations.end(),
                        [](const MutationRecord& record) { return record.operator_id == "root"; });
        if (new_body) CHECK(one->body_born == one->born);
        if (new_body && one->born > 0) ++renewed;
        if (!new_body && one->body_born < one->born) ++kept;
    }
    CHECK(kept > 0);
    CHECK(renewed > 0);
}

TEST_CASE("an interrupted generation goes on where it stopped", "[evolution]") {
    Evolution straight(small_settings(), kinds());
    Evolution broken(small_settings(), kinds());
    FakeBackend backend;
    run(straight, backend, 3);
    const int evaluations = std::exchange(backend.evaluations, 0);
    EvaluationProgress progress;
    for (int i = 0; i < 3; ++i) {
        if (i > 0) broken.breed();
        backend.stop_after = 5;
        REQUIRE_FALSE(broken.evaluate(backend, progress, {}));
        CHECK_FALSE(broken.evaluated());
        REQUIRE(broken.evaluate(backend, progress, {}));
    }
    CHECK(hashes(straight) == hashes(broken));
    CHECK(backend.evaluations == evaluations);
}

TEST_CASE("survivors are not evaluated again until the world changes", "[evolution]") {
    auto settings = small_settings(50);
    settings->selection.confirmations = 0;
    Evolution evolution(settings, kinds());
    FakeBackend backend;
    run(evolution, backend, 1);
    CHECK(backend.evaluations <= 50);
    backend.evaluations = 0;
    evolution.breed();
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    CHECK(backend.evaluations <= 40);

    auto moon = std::make_shared<ExperimentSettings>(*settings);
    moon->world.environment.gravity = 1.62;
    evolution.replace_settings(moon);
    evolution.breed();
    backend.evaluations = 0;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    std::set<std::uint64_t> distinct;
    for (const IndividualPtr& one : evolution.population())
        distinct.insert(one->result.phenotype);
    CHECK(backend.evaluations == static_cast<int>(distinct.size()));
}

TEST_CASE("rescored survivors lose what another simulator gave them", "[evolution]") {
    const auto settings = small_settings();
    FakeBackend backend;
    EvaluationProgress progress;
    Evolution honest(settings, kinds());
    run(honest, backend, 2);
    EvolutionState flattered{
        settings, honest.generation(), honest.population(), honest.history(), {}, {}, {}, {}};
    for (IndividualPtr& each : flattered.population) {
        Individual changed = *each;
        changed.result.fitness += 1000.0;
        each = std::make_shared<const Individual>(std::move(changed));
    }
    Evolution kept(flattered, kinds());
    kept.breed();
    REQUIRE(kept.evaluate(backend, progress, {}));
    CHECK(kept.population().front()->result.fitness >= 1000.0);

    Evolution rescored(flattered, kinds());
    rescored.breed();
    rescored.rescore();
    REQUIRE(rescored.evaluate(backend, progress, {}));
    std::set<std::uint64_t> known;
    for (const IndividualPtr& each : honest.population())
        known.insert(each->uid);
    int survivors = 0;
    for (const IndividualPtr& each : rescored.population()) {
        CHECK(each->result.fitness < 1000.0);
        survivors += known.contains(each->uid) ? 1 : 0;
    }
    CHECK(survivors > 0);
    CHECK(rescored.population().front()->result.fitness >=
          honest.population().front()->result.fitness);
}

TEST_CASE("a generation keeps its size under any mix of settings", "[evolution]") {
    for (const int size : {2, 3, 17, 60}) {
        auto settings = small_settings(size);
        settings->population.immigrants = size / 3;
        settings->population.max_clones = 1;
        Evolution evolution(settings, kinds());
        FakeBackend backend;
        run(evolution, backend, 6);
        CHECK(evolution.population().size() == static_cast<std::size_t>(size));
    }
}

TEST_CASE("founders given by hand fill a population with their mutants", "[evolution]") {
    RandomStream stream(3);
    const auto founder = std::make_shared<const Genome>(
        random_genome(FounderSettings{}, kinds().creature.catalog, stream));
    Evolution evolution(small_settings(30), kinds(), {founder});
    CHECK(*evolution.population().front()->genome == *founder);
    CHECK(evolution.population().size() == 30);
    const auto all = hashes(evolution);
    const std::set<std::uint64_t> distinct(all.begin(), all.end());
    CHECK(distinct.size() > 10);
    CHECK(distinct.size() < 30);  // a quarter of the mutants are unchanged copies
}

TEST_CASE("random creatures fill up beside given founders if the settings say so", "[evolution]") {
    RandomStream stream(3);
    std::vector<GenomePtr> founders;
    for (int i = 0; i < 3; ++i) {
        founders.push_back(std::make_shared<const Genome>(
            random_genome(FounderSettings{}, kinds().creature.catalog, stream)));
    }
    auto settings = small_settings(20);
    settings->population.fill = "random";
    Evolution evolution(settings, kinds(), founders);
    for (std::size_t i = 0; i < 20; ++i) {
        const Individual& one = *evolution.population()[i];
        CHECK(one.method == (i < 3 ? "imported" : "random"));
        if (i < 3) CHECK(one.genome == founders[i]);
    }
}

TEST_CASE("founders from a museum leave the other places to random creatures and come back in turn",
          "[evolution]") {
    RandomStream stream(3);
    std::vector<GenomePtr> founders;
    for (int i = 0; i < 3; ++i) {
        founders.push_back(std::make_shared<const Genome>(
            random_genome(FounderSettings{}, kinds().creature.catalog, stream)));
    }
    auto settings = small_settings(20);
    settings->population.museum = 0.15;
    Evolution evolution(settings, kinds(), founders);
    for (std::size_t i = 0; i < 20; ++i)
        CHECK(evolution.population()[i]->method == (i < 3 ? "imported" : "random"));
    FakeBackend backend;
    run(evolution, backend, 1);
    for (std::uint32_t generation = 1; generation < 5; ++generation) {
        evolution.breed();
        const auto& next = evolution.population();
        const auto invited = std::count_if(next.begin(), next.end(), [&](const IndividualPtr& one) {
            return one->born == generation && one->method == "imported";
        });
        CHECK(invited == 1);
        CHECK(*next.back()->genome == *founders[generation % 3]);
        EvaluationProgress progress;
        REQUIRE(evolution.evaluate(backend, progress, {}));
    }
    settings->population.museum = 0.0;
    Evolution plain(settings, kinds(), founders);
    run(plain, backend, 1);
    plain.breed();
    CHECK(plain.population().back()->method != "imported");
}

TEST_CASE("more founders than places leave the first ones", "[evolution]") {
    RandomStream stream(3);
    std::vector<GenomePtr> founders;
    for (int i = 0; i < 5; ++i) {
        founders.push_back(std::make_shared<const Genome>(
            random_genome(FounderSettings{}, kinds().creature.catalog, stream)));
    }
    Evolution evolution(small_settings(3), kinds(), founders);
    REQUIRE(evolution.population().size() == 3);
    CHECK(evolution.population()[2]->genome == founders[2]);
}

TEST_CASE("an injected creature lives in the next generation", "[evolution]") {
    Evolution evolution(small_settings(), kinds());
    FakeBackend backend;
    run(evolution, backend, 1);
    Genome giant = *evolution.population().front()->genome;
    giant.nodes[0].length = 1.59;
    const auto injected = std::make_shared<const Genome>(giant);
    evolution.inject(injected);
    evolution.breed();
    const auto found =
        std::any_of(evolution.population().begin(), evolution.population().end(),
                    [&](const IndividualPtr& one) { return one->genome == injected; });
    CHECK(found);
}

TEST_CASE("where attributes decide, children are bred as their first parent asks", "[evolution]") {
    auto settings = small_settings();
    settings->breeding.choice = "attribute";
    settings->population.tuned = 0.0;  // tuned children are not bred
    std::vector<GenomePtr> founders;
    RandomStream stream(3);
    for (int i = 0; i < 40; ++i) {
        Genome genome = random_genome(FounderSettings{}, kinds().creature.catalog, stream);
        genome.reproduction = 3;  // grafting
        founders.push_back(std::make_shared<const Genome>(std::move(genome)));
    }
    Evolution evolution(settings, kinds(), founders);
    FakeBackend backend;
    run(evolution, backend, 1);
    evolution.breed();
    for (const IndividualPtr& one : evolution.population())
        CHECK((one->born == 0 || one->method == "grafting"));
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    std::set<int> attributes;
    for (int i = 0; i < 30; ++i) {
        evolution.breed();
        for (const IndividualPtr& one : evolution.population())
            attributes.insert(one->genome->reproduction);
        REQUIRE(evolution.evaluate(backend, progress, {}));
    }
    CHECK(attributes.size() > 1);  // the gene mutates
}

TEST_CASE("offspring name their parents, method and mutations", "[evolution]") {
    Evolution evolution(small_settings(), kinds());
    FakeBackend backend;
    run(evolution, backend, 4);
    int changed = 0;
    for (const IndividualPtr& one : evolution.population()) {
        if (one->born == 0) continue;
        CHECK(one->parents[0] != 0);
        CHECK((one->method == "tuning" || kinds().breeding.find(one->method) != nullptr));
        changed += one->mutations.empty() ? 0 : 1;
    }
    CHECK(changed > 0);
}

TEST_CASE("swimmers that become seekers are not replaced by creatures that cannot move",
          "[evolution]") {
    auto settings = small_settings(60);
    settings->goal = "swimming";
    adopt_defaults(*settings, *kinds().goals.find("swimming"));
    settings->world.trial.duration = 2.0;
    const auto backend = make_thread_pool_backend(kinds(), 2);
    Evolution evolution(settings, kinds());
    run(evolution, *backend, 5);
    ExperimentSettings seeking = evolution.settings();
    seeking.goal = "seeking";
    adopt_defaults(seeking, *kinds().goals.find("seeking"));
    seeking.world.trial.duration = 5.0;
    seeking.world.trial.trials = 2;
    evolution.replace_settings(std::make_shared<const ExperimentSettings>(seeking));
    evolution.breed();
    run(evolution, *backend, 5);
    const auto& population = evolution.population();
    const auto rejected = std::count_if(
        population.begin(), population.end(),
        [](const IndividualPtr& one) { return one->result.outcome == Outcome::kRejected; });
    CHECK(rejected < 12);
    CHECK(population.front()->result.outcome == Outcome::kCompleted);
}
