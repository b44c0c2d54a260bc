#include "persist/creature/champion_museum.h"

#include "core/files/file_io.h"
#include "evolution/evaluation/trials.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <iterator>

using namespace cambrian;
using test::kinds;

namespace {

// A crawler with so many further legs, scored in a short trial.
CreatureDocument scored_crawler(std::size_t legs = 0, double gravity = 9.81) {
    Genome genome = *test::crawler(kinds().creature.catalog);
    const EdgeGene edge = genome.nodes[0].edges.front();
    for (std::size_t leg = 0; leg < legs; ++leg) {
        genome.nodes[0].edges.push_back(edge);
        genome.nodes[0].edges.back().position = 0.1 + 0.2 * static_cast<double>(leg);
        genome.nodes[0].edges.back().angle = 0.0;
    }
    ExperimentSettings settings;
    settings.world.environment.gravity = gravity;
    settings.world.trial.duration = 0.5;
    settings.world.trial.settle_limit = 0.5;
    const GenomePtr shared = std::make_shared<const Genome>(genome);
    JudgedIndividual creature =
        unjudged(shared, std::make_shared<const ExperimentSettings>(settings));
    change_individual(creature, [&](Individual& one) {
        one.evaluated = true;
        one.result = evaluate_in_trials({.genome = shared, .trial_seed = trial_seed(settings)},
                                        settings, kinds());
        REQUIRE(one.result.outcome == Outcome::kCompleted);
        one.result.verdict = AuditVerdict::kClean;
    });
    return creature_document(creature, kinds());
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
    return std::distance(std::filesystem::directory_iterator(folder), {});
}

ExperimentSettings asking(double share, int size = 10, std::uint64_t seed = 1) {
    ExperimentSettings settings;
    settings.population.museum = share;
    settings.population.size = size;
    settings.seed = seed;
    return settings;
}

}  // namespace

TEST_CASE("a museum takes one creature of each body plan", "[persist][museum]") {
    const TemporaryDirectory folder;
    const std::filesystem::path museum = folder / "made" / "museum";
    CHECK(*admit(museum, scored_crawler(0), kinds()) == Admission::kNew);
    CHECK(*admit(museum, scored_crawler(0), kinds()) == Admission::kKnown);
    CHECK(*admit(museum, scored_crawler(1), kinds()) == Admission::kNew);
    // Another world decides nothing between two creatures of one plan.
    CHECK(*admit(museum, scored_crawler(0, 3.0), kinds()) == Admission::kKnown);
    CHECK(files_in(museum) == 2);
}

TEST_CASE("a better creature of the same plan, goal and world takes the place of the old one",
          "[persist][museum]") {
    const TemporaryDirectory folder;
    CreatureDocument weaker = scored_crawler();
    REQUIRE(*admit(folder.path(), weaker, kinds()) == Admission::kNew);
    const auto file = std::filesystem::directory_iterator(folder.path())->path();
    change_individual(weaker.creature, [](Individual& one) { one.result.fitness -= 1.0; });
    REQUIRE(save_creature(file, weaker, kinds()));
    CHECK(*admit(folder.path(), scored_crawler(), kinds()) == Admission::kInPlace);
    CHECK(files_in(folder.path()) == 1);
    CHECK(load_creature(file, kinds())->score() == scored_crawler().score());
    // A damaged file keeps nobody out.
    REQUIRE(write_file(file, "{"));
    CHECK(*admit(folder.path(), scored_crawler(), kinds()) == Admission::kInPlace);
}

TEST_CASE("a museum refuses what its trial does not prove", "[persist][museum]") {
    const TemporaryDirectory folder;
    CreatureDocument flattered = scored_crawler();
    change_individual(flattered.creature, [](Individual& one) { one.result.fitness += 0.25; });
    CHECK_FALSE(admit(folder.path(), flattered, kinds()));
    CreatureDocument suspect = scored_crawler();
    change_individual(suspect.creature,
                      [](Individual& one) { one.result.verdict = AuditVerdict::kSuspect; });
    CHECK(*admit(folder.path(), suspect, kinds()) == Admission::kNotEligible);
    CreatureDocument unscored = scored_crawler();
    unscored.creature.individual = without_score(*unscored.creature.individual);
    CHECK(*admit(folder.path(), unscored, kinds()) == Admission::kNotEligible);
    CHECK(files_in(folder.path()) == 0);
    REQUIRE(write_file(folder / "file", ""));
    const auto blocked = admit(folder / "file" / "museum", scored_crawler(), kinds());
    REQUIRE_FALSE(blocked);
    CHECK(blocked.error().message.find("file/museum") != std::string::npos);
}

TEST_CASE("founders from a museum follow from the seed, each at most once", "[persist][museum]") {
    const TemporaryDirectory folder;
    for (std::size_t legs = 0; legs < 4; ++legs)
        REQUIRE(*admit(folder.path(), scored_crawler(legs), kinds()) == Admission::kNew);
    REQUIRE(write_file(folder / "damaged.creature.json", "{"));
    REQUIRE(write_file(folder / "notes.txt", "not a creature"));
    const auto drawn = museum_founders(folder.path(), asking(0.2), kinds());
    REQUIRE(drawn.size() == 2);
    CHECK(genome_hash(*drawn[0]) != genome_hash(*drawn[1]));
    const auto again = museum_founders(folder.path(), asking(0.2), kinds());
    REQUIRE(again.size() == 2);
    CHECK(*again[0] == *drawn[0]);
    CHECK(*again[1] == *drawn[1]);
    CHECK(museum_founders(folder.path(), asking(1.0), kinds()).size() == 4);
    CHECK(museum_founders(folder.path(), asking(0.0), kinds()).empty());
    CHECK(museum_founders(folder / "missing", asking(1.0), kinds()).empty());
    // Creatures of the plane are no founders in space.
    CHECK(museum_founders(folder.path(), asking(1.0), test::spatial_kinds()).empty());
    const auto first_of = [&](std::uint64_t seed) {
        return genome_hash(*museum_founders(folder.path(), asking(0.1, 10, seed), kinds())[0]);
    };
    bool differs = false;
    for (std::uint64_t seed = 2; seed < 12; ++seed)
        differs = differs || first_of(seed) != first_of(1);
    CHECK(differs);
}
