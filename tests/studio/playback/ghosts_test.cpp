#include "studio/playback/ghosts.h"

#include "studio_fixture.h"

namespace cambrian {
namespace {

// Returns the champions of a run with these scores. A champion with the same score as the one
// before is the same creature.
std::vector<JudgedIndividual> champions_of(const std::vector<double>& scores) {
    std::vector<JudgedIndividual> champions;
    auto settings = std::make_shared<ExperimentSettings>();
    for (const double score : scores) {
        const bool same =
            !champions.empty() && champions.back().individual->result.fitness == score;
        auto individual = std::make_shared<Individual>();
        individual->genome = same ? champions.back().individual->genome
                                  : test::crawler(test::kinds().creature.catalog);
        individual->result.fitness = score;
        champions.push_back({static_cast<std::uint32_t>(champions.size()), individual, settings});
    }
    return champions;
}

std::vector<std::uint32_t> generations(const std::vector<const JudgedIndividual*>& records) {
    std::vector<std::uint32_t> numbers;
    for (const JudgedIndividual* each : records)
        numbers.push_back(each->generation);
    return numbers;
}

TEST_CASE("ghosts are the champions that were chosen, without the one on display",
          "[studio][ghosts]") {
    const auto champions = champions_of({1, 1, 3, 2, 4, 4, 5, 4.5});
    const Genome* shown = champions[6].individual->genome.get();
    using Numbers = std::vector<std::uint32_t>;
    CHECK(choose_ghosts(champions, GhostChoice::kNone, shown).empty());
    CHECK(generations(choose_ghosts(champions, GhostChoice::kImprovements, shown)) ==
          Numbers{0, 2, 4});
    CHECK(generations(choose_ghosts(champions, GhostChoice::kImprovements, nullptr)) ==
          Numbers{2, 4, 6});
    CHECK(generations(choose_ghosts(champions, GhostChoice::kTenths, nullptr)) == Numbers{0});
    CHECK(generations(choose_ghosts(champions, GhostChoice::kAcross, nullptr)) ==
          Numbers{1, 3, 5, 7});
    CHECK(choose_ghosts({}, GhostChoice::kAcross, nullptr).empty());
}

class GhostRun {
public:
    GhostRun() {
        for (int i = 0; i < 3; ++i)
            studio.finish_generation(1.0 + i);
        studio.show_crawler();
    }
    void update() {
        ghosts.update(studio.snapshot(), GhostChoice::kImprovements, studio.playback(), 0.0, 1e3);
    }
    void play_to(std::uint64_t tick) {
        studio.playback().seek(tick);
        studio.playback().advance(0.0, 1e3);
        update();
    }
    test::StudioFixture studio;
    Ghosts ghosts{test::kinds().creature};
};

TEST_CASE("ghosts begin their test with the creature on display and follow it back",
          "[studio][ghosts]") {
    GhostRun run;
    for (int i = 0; i < 5; ++i)
        run.update();
    REQUIRE(run.ghosts.all().size() == 3);
    for (const std::uint64_t tick : {10U, 400U, 150U, 5U, 420U}) {
        run.play_to(tick);
        const Trial& leader = run.studio.playback().trial();
        for (const auto& ghost : run.ghosts.all()) {
            // The body and the world are the same, and so is the motion, bit by bit.
            CHECK(ghost->trial().ticks() == leader.ticks());
            CHECK(ghost->trial().scene().center_of_mass() == leader.scene().center_of_mass());
        }
    }
}

TEST_CASE("ghosts are in the same world as the displayed creature", "[studio][ghosts]") {
    GhostRun run;
    for (int i = 0; i < 5; ++i)
        run.update();
    run.play_to(60);
    Environment moon;
    moon.gravity = 1.62;
    run.studio.playback().creature().set_environment(moon);
    run.update();
    run.play_to(120);
    REQUIRE_FALSE(run.ghosts.all().empty());
    for (const auto& ghost : run.ghosts.all())
        CHECK(ghost->trial().scene().center_of_mass() ==
              run.studio.playback().trial().scene().center_of_mass());
}

TEST_CASE("ghosts are removed if none are chosen", "[studio][ghosts]") {
    GhostRun run;
    for (int i = 0; i < 5; ++i)
        run.update();
    run.ghosts.update(run.studio.snapshot(), GhostChoice::kNone, run.studio.playback(), 0.0, 1e3);
    CHECK(run.ghosts.all().empty());
}

TEST_CASE("a companion runs beside champions, the same way as they do", "[studio][ghosts]") {
    GhostRun run;
    Exhibit champion = test::crawler_exhibit();
    champion.source = ExhibitSource::kChampion;
    REQUIRE(run.studio.playback().show(champion));
    const auto update = [&](double travel) {
        run.ghosts.update(run.studio.snapshot(), GhostChoice::kNone, run.studio.playback(), travel,
                          1e3);
        return run.ghosts.all();
    };
    CHECK(update(1.0).empty());
    run.ghosts.run_beside(Companion{test::crawler_exhibit().creature, "Crawler, 1 BL/s", -2.0});
    REQUIRE(update(-1.0).size() == 1);
    run.play_to(200);
    const Ghost& same = *update(-1.0).front();
    CHECK(same.words() == "Crawler, 1 BL/s");
    const Pose straight = same.poses().back();
    const Pose mirrored = update(1.0).front()->poses().back();
    CHECK(straight.position.x() != 0.0);
    CHECK(mirrored.position.x() == -straight.position.x());
    CHECK(mirrored.position.y() == straight.position.y());
    CHECK(planar_angle(mirrored) == Approx(-planar_angle(straight)));
    run.studio.show_crawler();  // a sample, which is no champion
    CHECK(update(1.0).empty());
}

}  // namespace
}  // namespace cambrian
