#include "studio/panels/inspector/ancestry.h"

#include "studio_fixture.h"

namespace cambrian {
namespace {

IndividualPtr bred(IndividualPtr mother, std::uint32_t born, double fitness) {
    Individual individual;
    individual.uid = born + 1;
    individual.born = born;
    individual.genome = test::crawler(test::kinds().creature.catalog);
    individual.parents[0] = mother == nullptr ? 0 : mother->uid;
    individual.mother = ParentLink(std::move(mother));
    individual.method = born == 0 ? "random" : "asexual";
    individual.evaluated = true;
    individual.result.fitness = fitness;
    return std::make_shared<const Individual>(individual);
}

// Returns a creature whose line was born in generations 0, 3 and 7.
Exhibit third_generation() {
    const IndividualPtr founder = bred(nullptr, 0, 1.0);
    const IndividualPtr parent = bred(founder, 3, 1.5);
    Exhibit exhibit =
        exhibit_of({9, bred(parent, 7, 1.25), std::make_shared<const ExperimentSettings>()},
                   ExhibitSource::kChampion);
    exhibit.experiment = 4;
    return exhibit;
}

TEST_CASE("a line of descent leads to the founder, with the fitness gained in each step",
          "[studio][ancestry]") {
    const std::vector<AncestryStep> line = ancestry_of(third_generation());
    REQUIRE(line.size() == 3);
    CHECK(line[0].gained == -0.25);
    CHECK(line[1].gained == 0.5);
    CHECK_FALSE(line[2].gained);
    CHECK(line[2].individual->method == "random");
}

TEST_CASE("an ancestor is shown in the world that evaluated it", "[studio][ancestry]") {
    const Exhibit head = third_generation();
    const std::vector<AncestryStep> line = ancestry_of(head);
    EvolutionSnapshot snapshot;
    snapshot.experiment = 4;
    for (const std::uint32_t from : {0U, 2U, 6U}) {
        ExperimentSettings settings;
        settings.world.environment.gravity = 1.0 + from;
        snapshot.journal.push_back({from, std::make_shared<const ExperimentSettings>(settings)});
    }
    // The parent, born in generation 3, was last evaluated in generation 6, the founder in
    // generation 2.
    const Exhibit parent = ancestor_exhibit(head, line, 1, snapshot);
    CHECK(parent.settings().world.environment.gravity == 7.0);
    CHECK(parent.result());
    CHECK(ancestor_exhibit(head, line, 2, snapshot).settings().world.environment.gravity == 3.0);
    snapshot.experiment = 5;
    const Exhibit foreign = ancestor_exhibit(head, line, 1, snapshot);
    CHECK(foreign.settings().world.environment == head.settings().world.environment);
    CHECK_FALSE(foreign.result());
}

}  // namespace
}  // namespace cambrian
