#include "picking/picking_session.h"

#include "picking/body_backend.h"
#include "picking/creatures.h"
#include "support/catch.h"

#include <algorithm>
#include <limits>
#include <set>

using namespace cambrian;
using test::BodyBackend;
using test::default_settings;
using test::kinds;

namespace {

// A user of a session. Requested grids are made at once unless `lazy`.
class Person {
public:
    BodyBackend backend;
    bool lazy = false;
    PickingSession session{default_settings(), kinds()};

    Person() { obey(StartFromCreatures{{test::hopper()}}); }

    // Returns whether the command was carried out.
    bool obey(PickingCommand command) {
        session.apply(std::move(command));
        if (!lazy) finish_work();
        return shown().message.empty();
    }
    void finish_work() {
        EvaluationProgress progress;
        while (session.has_work())
            REQUIRE(session.work(backend, progress, {}));
    }
    bool pick(std::size_t cell) { return obey(TogglePick{grid().number, cell}); }
    const PickingSnapshot& shown() const { return session.snapshot(); }
    const GridNode& grid() const { return shown().tree.current(); }
    std::vector<std::uint64_t> hashes() const {
        std::vector<std::uint64_t> all;
        for (const IndividualPtr& each : grid().creatures)
            all.push_back(each->genome_hash);
        return all;
    }
};

}  // namespace

TEST_CASE("a session begins without a grid and takes no picks", "[picking][session]") {
    PickingSession session(default_settings(), kinds());
    for (const PickingCommand& command :
         {PickingCommand(TogglePick{}), PickingCommand(BreedPicks{}), PickingCommand(GoBack{}),
          PickingCommand(GoForward{}), PickingCommand(VisitGrid{}), PickingCommand(PinCreature{}),
          PickingCommand(ReplaceUnpicked{}), PickingCommand(AskEvolution{}),
          PickingCommand(PlacePinned{}), PickingCommand(UnpinCreature{}),
          PickingCommand(ClearPicks{}), PickingCommand(CancelDecision{}),
          PickingCommand(ShowPopulation{}), PickingCommand(UseSettings{}),
          PickingCommand(StartFromCreatures{{nullptr}})}) {
        session.apply(command);
        CAPTURE(command.index());
        CHECK_FALSE(session.snapshot().message.empty());
        CHECK_FALSE(session.has_work());
        CHECK(session.snapshot().tree.empty());
    }
}

TEST_CASE("the creature started from is in cell 1 of a full grid", "[picking][session]") {
    const Person person;
    CHECK(person.grid().creatures.size() == 12);
    CHECK(person.grid().creatures[0]->genome_hash == genome_hash(*test::hopper()));
    CHECK(person.grid().origin == GridOrigin::kCreatures);
    CHECK(person.shown().picks.empty());
}

TEST_CASE("at most four creatures of the displayed grid can be picked and unpicked",
          "[picking][session]") {
    Person person;
    for (const std::size_t cell : {5U, 2U, 9U, 0U})
        CHECK(person.pick(cell));
    CHECK(person.shown().picks == std::vector<std::size_t>{5, 2, 9, 0});
    CHECK_FALSE(person.pick(1));
    CHECK(person.shown().picks.size() == 4);
    CHECK(person.pick(2));
    CHECK(person.shown().picks == std::vector<std::size_t>{5, 9, 0});
    CHECK_FALSE(person.pick(12));
    CHECK_FALSE(person.obey(TogglePick{person.grid().number + 1, 3}));
    CHECK(person.shown().picks.size() == 3);
    CHECK(person.obey(ClearPicks{}));
    CHECK(person.shown().picks.empty());
}

TEST_CASE("children of the picks are bred before the user requests them", "[picking][session]") {
    Person person;
    CHECK_FALSE(person.shown().children_ready);
    person.pick(3);
    CHECK(person.shown().children_ready);
    const int evaluations = person.backend.evaluations;
    const IndividualPtr parent = person.grid().creatures[3];
    person.obey(BreedPicks{});
    CHECK(person.backend.evaluations == evaluations);
    CHECK(person.grid().creatures[0] == parent);
    CHECK(person.grid().picks == std::vector<std::size_t>{3});
    CHECK(person.grid().parent == 0U);
}

TEST_CASE("a grid is the same whether it was bred ahead or not, and after other picks",
          "[picking][session]") {
    Person ahead;
    ahead.pick(3);
    ahead.pick(7);
    ahead.obey(BreedPicks{});

    Person late;
    late.lazy = true;
    late.pick(7);
    late.pick(7);
    late.obey(ChangeGrid{{.cells = 25}});
    late.pick(3);
    late.pick(7);
    late.obey(ChangeGrid{{}});
    late.obey(BreedPicks{});
    CHECK(late.shown().status == PickingStatus::kBreeding);
    late.finish_work();
    CHECK(late.shown().status == PickingStatus::kOpen);
    CHECK(late.hashes() == ahead.hashes());
}

TEST_CASE("a decision needs picks and is refused while another one is pending",
          "[picking][session]") {
    Person person;
    CHECK_FALSE(person.obey(BreedPicks{}));
    CHECK_FALSE(person.obey(AskEvolution{}));
    person.lazy = true;
    person.pick(1);
    person.obey(BreedPicks{});
    CHECK_FALSE(person.pick(2));
    CHECK_FALSE(person.obey(BreedPicks{}));
    CHECK_FALSE(person.obey(ReplaceUnpicked{}));
    CHECK(person.shown().decisions == 1);
    CHECK(person.obey(CancelDecision{}));
    CHECK(person.shown().status == PickingStatus::kOpen);
    CHECK(person.shown().picks == std::vector<std::size_t>{1});
    CHECK(person.shown().tree.size() == 1);
}

TEST_CASE("going back restores the picks, and breeding again makes a new branch",
          "[picking][session]") {
    Person person;
    person.pick(4);
    person.obey(BreedPicks{});
    const auto first = person.hashes();
    CHECK(person.obey(GoBack{}));
    CHECK(person.shown().picks == std::vector<std::size_t>{4});
    person.obey(BreedPicks{});
    CHECK(person.grid().number == 2);
    CHECK(person.grid().parent == 0U);
    CHECK(person.hashes() != first);
    CHECK(person.shown().branches == 1);
    CHECK(person.obey(VisitGrid{1}));
    CHECK(person.hashes() == first);
    CHECK_FALSE(person.obey(VisitGrid{3}));
    CHECK_FALSE(person.obey(GoForward{}));
    CHECK(person.obey(GoBack{}));
    CHECK(person.obey(GoForward{}));
    CHECK(person.grid().number == 1);
    CHECK(person.obey(GoBack{}));
    CHECK_FALSE(person.obey(GoBack{}));
}

TEST_CASE("going back undoes a decision that is not ready", "[picking][session]") {
    Person person;
    person.pick(4);
    person.lazy = true;
    person.obey(ReplaceUnpicked{});
    REQUIRE(person.shown().status == PickingStatus::kBreeding);
    CHECK(person.obey(GoBack{}));
    CHECK(person.shown().status == PickingStatus::kOpen);
    CHECK(person.grid().number == 0);
    CHECK(person.shown().picks == std::vector<std::size_t>{4});
}

TEST_CASE("random creatures replace those that are not picked", "[picking][session]") {
    Person person;
    person.pick(4);
    person.pick(8);
    const GridNode before = person.grid();
    CHECK(person.obey(ReplaceUnpicked{}));
    CHECK(person.grid().origin == GridOrigin::kImmigrants);
    for (std::size_t cell = 0; cell < 12; ++cell) {
        const bool stays = cell == 4 || cell == 8;
        CHECK((person.grid().creatures[cell] == before.creatures[cell]) == stays);
        CHECK((person.grid().creatures[cell]->method == "random") == !stays);
    }
    CHECK(person.obey(ReplaceUnpicked{}));  // replaces all creatures
    CHECK(person.grid().creatures[4]->method == "random");
}

TEST_CASE("picks are moved into a grid that becomes smaller", "[picking][session]") {
    Person person;
    const IndividualPtr low = person.grid().creatures[1];
    const IndividualPtr high = person.grid().creatures[11];
    person.pick(11);
    person.pick(1);
    person.obey(ChangeGrid{{.cells = 4}});
    CHECK(person.obey(ReplaceUnpicked{}));
    REQUIRE(person.grid().creatures.size() == 4);
    CHECK(person.grid().creatures[0] == high);
    CHECK(person.grid().creatures[1] == low);
    for (std::size_t cell = 0; cell < 4; ++cell)
        CHECK(person.pick(cell));
    CHECK_FALSE(person.obey(ReplaceUnpicked{}));  // no creature is left to replace
    CHECK(person.obey(BreedPicks{}));
    CHECK(person.grid().creatures.size() == 4);
}

TEST_CASE("sizes and dials out of range are refused", "[picking][session]") {
    Person person;
    const GridSettings before = person.shown().grid;
    for (const int cells : {-1, 0, 1, 5, 13, 26, 1000})
        CHECK_FALSE(person.obey(ChangeGrid{{.cells = cells}}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double weight : {-0.1, 1.1, nan})
        CHECK_FALSE(person.obey(ChangeGrid{{.fitness_weight = weight}}));
    CHECK(person.shown().grid == before);
    person.pick(0);
    for (const int generations : {-1, 0, 1001})
        CHECK_FALSE(person.obey(AskEvolution{generations}));
}

TEST_CASE("every size of grid is bred, at every boldness", "[picking][session]") {
    Person person;
    for (const int cells : kGridSizes) {
        for (const Boldness boldness : {Boldness::kGentle, Boldness::kBold, Boldness::kWild}) {
            person.obey(ChangeGrid{{.cells = cells, .boldness = boldness, .fitness_weight = 0.5}});
            person.pick(0);
            person.pick(1);
            REQUIRE(person.obey(BreedPicks{}));
            const GridNode& grid = person.grid();
            CHECK(grid.creatures.size() == static_cast<std::size_t>(cells));
            CHECK(grid.grid == person.shown().grid);
            const auto immigrants =
                std::count_if(grid.creatures.begin() + 1, grid.creatures.end(),
                              [](const IndividualPtr& each) { return each->method == "random"; });
            CHECK(immigrants == immigrant_cells(grid.grid));
        }
    }
}

TEST_CASE("creatures to start from must be valid, and four at most", "[picking][session]") {
    Person person;
    Genome broken = *test::hopper();
    broken.nodes[0].length = -1.0;
    CHECK_FALSE(person.obey(StartFromCreatures{{std::make_shared<const Genome>(broken)}}));
    CHECK_FALSE(person.obey(StartFromCreatures{std::vector<GenomePtr>(5, test::hopper())}));
    CHECK(person.shown().tree.size() == 1);
    CHECK(
        person.obey(StartFromCreatures{{test::hopper(), test::crawler(kinds().creature.catalog)}}));
    CHECK(person.grid().number == 1);
    CHECK(person.obey(StartFromCreatures{}));
    for (const IndividualPtr& each : person.grid().creatures)
        CHECK(each->method == "random");
    CHECK(person.obey(GoBack{}));
    CHECK(person.grid().number == 1);
}

TEST_CASE("automatic evolution from the picks fills a grid", "[picking][session]") {
    Person person;
    person.pick(2);
    person.lazy = true;
    CHECK(person.obey(AskEvolution{4}));
    CHECK(person.shown().status == PickingStatus::kEvolving);
    EvaluationProgress progress;
    int done = 0;
    while (person.shown().status == PickingStatus::kEvolving) {
        CHECK(person.shown().generations_done >= done);
        CHECK(person.shown().generations_asked == 4);
        done = person.shown().generations_done;
        REQUIRE(person.session.work(person.backend, progress, {}));
    }
    CHECK(person.grid().origin == GridOrigin::kAssistance);
    CHECK(person.grid().generations == 4);
    REQUIRE(person.grid().creatures.size() == 12);
    const std::vector<std::uint64_t> all = person.hashes();
    CHECK(std::set<std::uint64_t>(all.begin(), all.end()).size() == 12);
    double mean = 0.0;
    for (const IndividualPtr& each : person.grid().creatures)
        mean += each->result.fitness / 12.0;
    CHECK(mean > person.shown().tree.node(0).creatures[2]->result.fitness);
}

TEST_CASE("selection by hand from a population can alternate with automatic runs",
          "[picking][session]") {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 40;
    settings->seed = 12;
    BodyBackend backend;
    EvaluationProgress progress;
    Evolution evolution(settings, kinds());
    REQUIRE(evolution.evaluate(backend, progress, {}));

    Person person;
    person.backend.evaluations = 0;
    CHECK(person.obey(ShowPopulation{settings, evolution.population()}));
    CHECK(person.backend.evaluations == 0);
    CHECK(person.grid().origin == GridOrigin::kPopulation);
    CHECK(person.shown().settings == settings);
    for (const IndividualPtr& each : person.grid().creatures) {
        CHECK(std::count(evolution.population().begin(), evolution.population().end(), each) == 1);
    }
    CHECK(std::count(person.grid().creatures.begin(), person.grid().creatures.end(),
                     evolution.population().front()) == 1);

    person.obey(ChangeGrid{{.fitness_weight = 1.0}});
    person.obey(ShowPopulation{settings, evolution.population()});
    double worst = std::numeric_limits<double>::infinity();
    for (const IndividualPtr& each : person.grid().creatures)
        worst = std::min(worst, each->result.fitness);
    const auto better_ones =
        std::count_if(evolution.population().begin(), evolution.population().end(),
                      [&](const IndividualPtr& each) { return each->result.fitness > worst; });
    CHECK(better_ones < 14);  // the twelve fittest, except creatures that cannot move
}

TEST_CASE("under other settings the parent is evaluated again", "[picking][session]") {
    Person person;
    auto moon = std::make_shared<ExperimentSettings>();
    moon->world.environment.gravity = 1.62;
    person.backend.adjust = [](const Genome&, EvaluationResult& result) { result.fitness = -5.0; };
    person.pick(0);
    person.obey(UseSettings{moon});
    CHECK(person.shown().children_ready);
    person.obey(BreedPicks{});
    CHECK(person.grid().creatures[0]->result.fitness == -5.0);
    CHECK(person.grid().settings == moon);
    CHECK(person.shown().tree.node(0).creatures[0]->result.fitness != -5.0);
}

TEST_CASE("pinned creatures outlast all commands and can be put into any grid",
          "[picking][session]") {
    Person person;
    const IndividualPtr kept = person.grid().creatures[6];
    CHECK(person.obey(PinCreature{0, 6}));
    CHECK_FALSE(person.obey(PinCreature{0, 12}));
    CHECK_FALSE(person.obey(PinCreature{1, 0}));
    person.pick(0);
    person.obey(BreedPicks{});
    person.obey(StartFromCreatures{});
    CHECK_FALSE(person.obey(PlacePinned{1, person.grid().number, 3}));
    const GridNode before = person.grid();
    CHECK(person.obey(PlacePinned{0, person.grid().number, 3}));
    CHECK(person.grid().parent == before.number);
    for (std::size_t cell = 0; cell < 12; ++cell)
        CHECK(person.grid().creatures[cell] == (cell == 3 ? kept : before.creatures[cell]));
    CHECK(person.obey(UnpinCreature{0}));
    CHECK(person.shown().shelf.empty());
    CHECK_FALSE(person.obey(UnpinCreature{0}));
}

TEST_CASE("decisions and branches are counted", "[picking][session]") {
    Person person;
    person.pick(0);
    person.obey(BreedPicks{});
    person.pick(0);
    person.obey(BreedPicks{});
    person.obey(GoBack{});
    person.obey(ReplaceUnpicked{});
    CHECK(person.shown().decisions == 3);
    CHECK(person.shown().branches == 1);
}

TEST_CASE("a back-end that fails cancels the decision and changes nothing else",
          "[picking][session]") {
    Person person;
    person.pick(0);
    person.obey(BreedPicks{});
    person.lazy = true;
    person.pick(0);
    person.session.fail("out of luck");
    CHECK(person.shown().message == "out of luck");
    CHECK_FALSE(person.session.has_work());
    CHECK(person.shown().picks == std::vector<std::size_t>{0});
    CHECK(person.obey(BreedPicks{}));
    person.finish_work();
    CHECK(person.grid().number == 2);
}

TEST_CASE("a sequence of commands is reproducible bit for bit", "[picking][session]") {
    const auto walk = [](std::uint64_t seed) {
        Person person;
        RandomStream stream(seed);
        std::vector<std::uint64_t> seen;
        for (int i = 0; i < 12; ++i) {
            person.pick(stream.below(person.grid().creatures.size()));
            switch (stream.below(4)) {
                case 0:
                    person.obey(GoBack{});
                    break;
                case 1:
                    person.obey(ReplaceUnpicked{});
                    break;
                default:
                    person.obey(BreedPicks{});
            }
            for (const std::uint64_t hash : person.hashes())
                seen.push_back(hash);
        }
        return seen;
    };
    CHECK(walk(1) == walk(1));
    CHECK(walk(1) != walk(2));
}
