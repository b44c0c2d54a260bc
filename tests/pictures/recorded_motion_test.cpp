#include "pictures/recorded_motion.h"

#include "support/creatures.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

TrialWorld short_world() {
    TrialWorld world;
    world.trial.duration = 0.5;
    return world;
}

RecordedTrial crawl() {
    const auto genome = test::crawler(test::kinds().creature.catalog);
    auto phenotype =
        std::make_shared<const Phenotype>(express(*genome, test::kinds().creature, {}, {}));
    auto recorded = record_trial(phenotype, test::kinds().creature, short_world());
    REQUIRE(recorded);
    return std::move(*recorded);
}

TEST_CASE("a recorded trial is the one that judges, from the end of settling on",
          "[pictures][recorded_motion]") {
    const RecordedTrial recorded = crawl();
    const auto judged = run_trial(recorded.motion.phenotype, test::kinds().creature, short_world());
    REQUIRE(judged);
    CHECK(recorded.record.digest == judged->digest);
    CHECK(recorded.motion.frames.size() == 31);
    CHECK(recorded.motion.length() == Approx(0.5));
    const Vec3 start = recorded.motion.frames.front().center_of_mass;
    CHECK(start == judged->samples.front().center_of_mass);
    const Vec3 end = recorded.motion.frames.back().center_of_mass;
    CHECK(end == judged->samples.back().center_of_mass);
}

TEST_CASE("between two moments the parts are between them, after the last they rest",
          "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    const MotionFrame middle = motion.at(10.5 * kBrainTick);
    const Vec3 expected =
        0.5 * (motion.frames[10].center_of_mass + motion.frames[11].center_of_mass);
    CHECK((middle.center_of_mass - expected).norm() < 1e-12);
    CHECK(motion.at(100.0).center_of_mass == motion.frames.back().center_of_mass);
    CHECK(motion.at(-1.0).center_of_mass == motion.frames.front().center_of_mass);
}

TEST_CASE("the trail ends where the creature is and is no longer than asked for",
          "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    CHECK(motion.trail(0.0, 60).empty());
    const auto trail = motion.trail(0.4, 60);
    REQUIRE(trail.size() == 6);
    CHECK(trail.back() == motion.frames[24].center_of_mass.head<2>());
    CHECK(motion.trail(0.4, 2).size() == 2);
    CHECK(motion.trail(0.4, 2).back() == trail.back());
}

TEST_CASE("a part's touched faces are kept with each moment", "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    for (const MotionFrame& frame : motion.frames)
        CHECK(frame.touched.size() == frame.poses.size());
    FaceSet any = 0;
    for (const FaceSet faces : motion.frames.front().touched)
        any = static_cast<FaceSet>(any | faces);
    CHECK(any != 0);
}

}  // namespace
}  // namespace cambrian
