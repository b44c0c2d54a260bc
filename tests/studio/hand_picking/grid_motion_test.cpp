#include "studio/hand_picking/grid_motion.h"

#include "support/creatures.h"
#include "support/kinds.h"

#include <chrono>
#include <thread>

namespace cambrian {
namespace {

TrialWorld short_world() {
    TrialWorld world;
    world.trial.duration = 0.5;
    return world;
}

std::vector<IndividualPtr> two_creatures() {
    std::vector<IndividualPtr> creatures;
    for (const GenomePtr& genome : {test::crawler(test::kinds().creature.catalog),
                                    test::fish(test::kinds().creature.catalog)}) {
        auto creature = std::make_shared<Individual>();
        creature->genome = genome;
        creatures.push_back(creature);
    }
    return creatures;
}

// Runs frames until every motion is computed.
void finish(GridMotion& motion) {
    const auto complete = [&] {
        for (std::size_t i = 0; i < motion.size(); ++i) {
            if (!motion.cell(i).complete) return false;
        }
        return true;
    };
    for (int i = 0; i < 20'000 && !complete(); ++i) {
        motion.advance(0.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    REQUIRE(complete());
}

TEST_CASE("a grid shows the motion of the evaluated trial without its settling",
          "[studio][grid_motion]") {
    GridMotion motion(test::kinds().creature);
    const auto creatures = two_creatures();
    motion.show(creatures, {}, short_world());
    finish(motion);
    const RecordedMotion& shown = motion.cell(0);
    auto trial = Trial::start(shown.phenotype, test::kinds().creature, short_world());
    REQUIRE(trial);
    while ((*trial)->tick()) {
    }
    const std::size_t parts = shown.phenotype->parts.size();
    for (std::size_t part = 0; part < parts; ++part) {
        CHECK(shown.frames.back().poses[part].position ==
              (*trial)->scene().part_pose(part).position);
    }
    CHECK(shown.length() == Approx(0.5).margin(0.05));
}

TEST_CASE("all cells share one clock, which waits for motion and restarts at the end",
          "[studio][grid_motion]") {
    GridMotion motion(test::kinds().creature);
    motion.advance(0.05);
    CHECK(motion.time() == 0.0);
    motion.show(two_creatures(), {}, short_world());
    CHECK(motion.cell(0).empty());
    finish(motion);
    motion.advance(0.05);
    CHECK(motion.time() == Approx(0.05));
    bool wrapped = false;
    for (int i = 0; i < 20 && !wrapped; ++i) {
        const double before = motion.time();
        motion.advance(0.05);
        wrapped = motion.time() < before;
    }
    CHECK(wrapped);
}

TEST_CASE("a new grid cancels the computations for the one before", "[studio][grid_motion]") {
    GridMotion motion(test::kinds().creature);
    const auto creatures = two_creatures();
    motion.show({creatures[0], creatures[0]}, {}, short_world());
    motion.show({creatures[1]}, {}, short_world());
    finish(motion);
    REQUIRE(motion.size() == 1);
    CHECK(motion.cell(0).phenotype->parts.size() == creatures[1]->genome->nodes.size());
}

TEST_CASE("poses are interpolated between two frames", "[studio][grid_motion]") {
    RecordedMotion motion;
    for (const double x : {0.0, 1.0}) {
        MotionFrame frame;
        frame.poses.resize(1);
        frame.poses[0].position = Vec3(x, 0.0, 0.0);
        frame.center_of_mass = Vec3(x, 0.0, 0.0);
        motion.frames.push_back(frame);
    }
    CHECK(motion.at(0.25 * kBrainTick).poses[0].position.x() == Approx(0.25));
    CHECK(motion.at(5.0).center_of_mass.x() == 1.0);
}

}  // namespace
}  // namespace cambrian
