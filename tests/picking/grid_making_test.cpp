#include "picking/grid/grid_making.h"

#include "evolution/backends/thread_pool_backend.h"
#include "picking/body_backend.h"
#include "picking/creatures.h"
#include "picking/grid/grid_settings.h"
#include "support/build_speed.h"
#include "support/catch.h"

#include <algorithm>
#include <set>

using namespace cambrian;
using test::BodyBackend;
using test::kinds;

namespace {

SettingsPtr short_trials(double seconds = 1.0) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->world.trial.duration = seconds;
    return settings;
}

// Returns an order for children of the given parents, with the first parent in cell 1.
GridOrder children_of(std::vector<IndividualPtr> parents, int cells = 12) {
    GridOrder order;
    order.node = 5;
    order.cells = cells;
    if (!parents.empty()) order.kept.emplace(0, parents.front());
    order.parents = std::move(parents);
    return order;
}

std::vector<IndividualPtr> make_grid(const GridOrder& order, EvaluationBackend& backend,
                                     const SettingsPtr& settings = short_trials()) {
    GridMaking making(order, settings, kinds());
    EvaluationProgress progress;
    REQUIRE(making.run(backend, progress, {}));
    REQUIRE(making.done());
    REQUIRE(making.cells().size() == static_cast<std::size_t>(order.cells));
    return making.cells();
}

std::vector<std::uint64_t> uids(const std::vector<IndividualPtr>& creatures) {
    std::vector<std::uint64_t> all;
    for (const IndividualPtr& each : creatures)
        all.push_back(each->uid);
    return all;
}

std::size_t distinct(const std::vector<IndividualPtr>& creatures) {
    const auto all = uids(creatures);
    return std::set<std::uint64_t>(all.begin(), all.end()).size();
}

// Returns whether all creatures but the first are alive and different from each other.
bool all_alive(const std::vector<IndividualPtr>& grid) {
    const auto grades = grade_candidates(std::span(grid).subspan(1), {grid.front()->genome_hash});
    return std::all_of(grades.begin(), grades.end(),
                       [](CandidateGrade grade) { return grade == CandidateGrade::kAlive; });
}

}  // namespace

TEST_CASE("a grid is the same on one worker and on two", "[picking][making]") {
    for (std::size_t parents = 1; parents <= 3; ++parents) {
        GridOrder order = children_of(test::strangers(parents));
        order.immigrant_cells = 2;
        const auto one = make_thread_pool_backend(kinds(), 1);
        const auto two = make_thread_pool_backend(kinds(), 2);
        const auto first = make_grid(order, *one);
        const auto second = make_grid(order, *two);
        CHECK(uids(first) == uids(second));
        for (std::size_t i = 0; i < first.size(); ++i)
            CHECK(first[i]->result.digest == second[i]->result.digest);
    }
}

TEST_CASE("grids of random picks from random grids have no dead cells", "[picking][making]") {
    const auto backend = make_thread_pool_backend(kinds(), 2);
    constexpr std::uint64_t seeds = test::by_build(100, 12);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        RandomStream stream(seed);
        GridOrder first;
        first.node = static_cast<std::uint32_t>(1000 + seed);
        auto picks = make_grid(first, *backend);
        stream.shuffle(std::span(picks));
        picks.resize(1 + seed % 4);
        GridOrder order = children_of(picks, kGridSizes[seed % 6]);
        order.extra_mutations = static_cast<int>(seed % 3);
        order.immigrant_cells = static_cast<int>(seed % 2);
        const auto grid = make_grid(order, *backend);
        CAPTURE(seed);
        CHECK(all_alive(grid));
        CHECK(grid.front() == picks.front());
        CHECK(std::all_of(grid.begin(), grid.end(),
                          [](const IndividualPtr& each) { return each->evaluated; }));
    }
}

TEST_CASE("a grid has no dead cells even if most candidates are dead", "[picking][making]") {
    BodyBackend backend;
    backend.adjust = [](const Genome& genome, EvaluationResult& result) {
        const std::uint64_t lot = genome_hash(genome) % 10;
        if (lot < 4) result.behavior.stir = 0.0;
        if (lot == 4) result.outcome = Outcome::kDiverged;
        if (lot == 5) result.outcome = Outcome::kDisqualified;
    };
    constexpr std::uint64_t seeds = test::by_build(400, 60);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const auto grid = make_grid(
            children_of(test::strangers(1 + seed % 4, seed), kGridSizes[seed % 6]), backend);
        CAPTURE(seed);
        CHECK(all_alive(grid));
    }
}

TEST_CASE("a grid is filled with the best candidates if all are dead", "[picking][making]") {
    BodyBackend backend;
    backend.adjust = [](const Genome& genome, EvaluationResult& result) {
        result.behavior.stir = 0.0;
        if (genome_hash(genome) % 2 == 0) result.outcome = Outcome::kDiverged;
    };
    const auto still = make_grid(children_of(test::strangers(1), 25), backend);
    for (std::size_t i = 1; i < still.size(); ++i)
        CHECK(still[i]->result.outcome != Outcome::kDiverged);
    backend.adjust = [](const Genome&, EvaluationResult& result) {
        result.outcome = Outcome::kOverBudget;
    };
    CHECK(make_grid(children_of(test::strangers(2), 16), backend).size() == 16);
}

TEST_CASE("further rounds mutate more if too few candidates differ", "[picking][making]") {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->mutation.scheme = "none";
    BodyBackend backend;
    const auto grid = make_grid(children_of(test::strangers(1)), backend, settings);
    CHECK(all_alive(grid));
    for (std::size_t i = 1; i < grid.size(); ++i)
        CHECK(grid[i]->mutations.size() == 1);
}

TEST_CASE("without mutation a grid is filled with copies in bounded time", "[picking][making]") {
    auto settings = std::make_shared<ExperimentSettings>();
    for (const MutationKind& kind : kinds().mutations.all())
        settings->mutation.weights[kind.id] = 0.0;
    BodyBackend backend;
    const auto grid = make_grid(children_of(test::strangers(1)), backend, settings);
    for (const IndividualPtr& each : grid)
        CHECK(each->genome_hash == grid.front()->genome_hash);
    CHECK(backend.evaluations == 1);
}

TEST_CASE("wild grids have random immigrants", "[picking][making]") {
    BodyBackend backend;
    GridOrder order = children_of(test::strangers(2));
    order.immigrant_cells = 2;
    const auto grid = make_grid(order, backend);
    CHECK(std::count_if(grid.begin() + 1, grid.end(),
                        [](const IndividualPtr& each) { return each->method == "random"; }) == 2);
}

TEST_CASE("kept creatures stay in their cells", "[picking][making]") {
    BodyBackend backend;
    const auto picks = test::strangers(2);
    GridOrder order;
    order.cells = 9;
    order.kept = {{3, picks[0]}, {7, picks[1]}};
    const auto grid = make_grid(order, backend);
    CHECK(grid[3]->uid == picks[0]->uid);
    CHECK(grid[7]->uid == picks[1]->uid);
    CHECK(distinct(grid) == 9);
}

TEST_CASE("a population is shown without any evaluation", "[picking][making]") {
    BodyBackend backend;
    GridOrder everyone;
    everyone.cells = 25;
    GridOrder order;
    order.pool = make_grid(everyone, backend);
    order.cells = 9;
    backend.evaluations = 0;
    const auto grid = make_grid(order, backend);
    CHECK(backend.evaluations == 0);
    CHECK(std::is_sorted(grid.begin(), grid.end(),
                         [](const auto& a, const auto& b) { return a->uid < b->uid; }));
    const auto fittest = std::max_element(
        order.pool.begin(), order.pool.end(),
        [](const auto& a, const auto& b) { return a->result.fitness < b->result.fitness; });
    CHECK(std::count(grid.begin(), grid.end(), *fittest) == 1);
}

TEST_CASE("a population too small or too uniform is filled up", "[picking][making]") {
    BodyBackend backend;
    GridOrder order;
    order.pool = test::strangers(3);
    order.pool.push_back(order.pool.front());
    const auto grid = make_grid(order, backend);
    const auto all = uids(grid);
    CHECK(distinct(grid) == 12);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::count(all.begin(), all.end(), order.pool[i]->uid) == 1);
}

TEST_CASE("an interrupted grid is continued where it stopped", "[picking][making]") {
    const GridOrder order = children_of(test::strangers(2));
    BodyBackend backend;
    const auto whole = make_grid(order, backend);
    const int all = backend.evaluations;
    backend.evaluations = 0;

    GridMaking making(order, short_trials(), kinds());
    EvaluationProgress progress;
    int interruptions = 0;
    for (bool done = false; !done;) {
        std::stop_source stop;
        int left = 5;
        backend.adjust = [&](const Genome&, EvaluationResult&) {
            if (--left == 0) stop.request_stop();
        };
        done = making.run(backend, progress, stop.get_token());
        interruptions += done ? 0 : 1;
        REQUIRE(interruptions < 100);
    }
    CHECK(interruptions > 3);
    CHECK(uids(making.cells()) == uids(whole));
    CHECK(backend.evaluations == all);
}
