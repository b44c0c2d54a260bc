#include "pictures/motion/recorded_motion.h"

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

TEST_CASE("a recorded trial equals the evaluated one from the end of settling",
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

TEST_CASE("poses are interpolated between two moments and constant after the last",
          "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    const MotionFrame middle = motion.at(10.5 * kBrainTick);
    const Vec3 expected =
        0.5 * (motion.frames[10].center_of_mass + motion.frames[11].center_of_mass);
    CHECK((middle.center_of_mass - expected).norm() < 1e-12);
    CHECK(motion.at(100.0).center_of_mass == motion.frames.back().center_of_mass);
    CHECK(motion.at(-1.0).center_of_mass == motion.frames.front().center_of_mass);
}

TEST_CASE("the trail ends at the creature and has at most the requested length",
          "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    CHECK(motion.trail(0.0, 60).empty());
    const auto trail = motion.trail(0.4, 60);
    REQUIRE(trail.size() == 6);
    CHECK(trail.back() == motion.frames[24].center_of_mass.head<2>());
    CHECK(motion.trail(0.4, 2).size() == 2);
    CHECK(motion.trail(0.4, 2).back() == trail.back());
}

TEST_CASE("each moment has the touched faces of every part", "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    for (const MotionFrame& frame : motion.frames)
        CHECK(frame.touched.size() == frame.poses.size());
    FaceSet any = 0;
    for (const FaceSet faces : motion.frames.front().touched)
        any = static_cast<FaceSet>(any | faces);
    CHECK(any != 0);
}

TEST_CASE("a motion that is too long is recorded at a larger interval with exact frames",
          "[pictures][recorded_motion]") {
    const RecordedMotion whole = crawl().motion;
    const MotionFrame& first = whole.frames.front();
    const std::size_t frame_bytes = sizeof(MotionFrame) +
                                    first.poses.size() * (sizeof(Pose) + sizeof(double)) +
                                    first.touched.size() * sizeof(FaceSet);
    for (const std::size_t frames : {2U, 5U, 12U, 30U}) {
        auto recorded = record_trial(whole.phenotype, test::kinds().creature, short_world(), {},
                                     frames * frame_bytes);
        REQUIRE(recorded);
        const RecordedMotion& motion = recorded->motion;
        INFO(motion.stride << " ticks a frame");
        CHECK(motion.stride > 1);
        CHECK(motion.length() == whole.length());
        CHECK(motion.frames.size() == 30 / motion.stride + 1);
        for (std::size_t i = 0; i < motion.frames.size(); ++i) {
            const std::size_t tick = i * motion.stride;
            CHECK(motion.frames[i].center_of_mass == whole.frames[tick].center_of_mass);
            const double time = (static_cast<double>(tick) + 0.25) * kBrainTick;
            CHECK(motion.at(time).center_of_mass == whole.frames[tick].center_of_mass);
        }
        CHECK(motion.trail(0.4, 60) == whole.trail(0.4, 60));
        CHECK(recorded->record.digest == crawl().record.digest);
    }
}

TEST_CASE("a replayed motion equals the recorded one at every time",
          "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    auto replayed = ReplayedMotion::start(motion.phenotype, test::kinds().creature, short_world());
    REQUIRE(replayed);
    for (double time = 0.0; time < 0.7; time += 0.0071) {
        const MotionFrame expected = motion.at(time);
        const MotionFrame frame = replayed->at(time);
        INFO(time << " s");
        CHECK(frame.center_of_mass == expected.center_of_mass);
        CHECK(frame.touched == expected.touched);
        for (std::size_t part = 0; part < frame.poses.size(); ++part) {
            CHECK(frame.poses[part].position == expected.poses[part].position);
            CHECK(frame.poses[part].orientation.coeffs() ==
                  expected.poses[part].orientation.coeffs());
        }
    }
}

TEST_CASE("the recording of a trial can be stopped and reports its progress",
          "[pictures][recorded_motion]") {
    const RecordedMotion motion = crawl().motion;
    std::atomic<double> time = 0.0;
    std::stop_source source;
    REQUIRE(record_trial(motion.phenotype, test::kinds().creature, short_world(),
                         {.stop = source.get_token(), .time = &time}));
    CHECK(time.load() == Approx(0.5));
    source.request_stop();
    const auto stopped = record_trial(motion.phenotype, test::kinds().creature, short_world(),
                                      {.stop = source.get_token(), .time = &time});
    REQUIRE_FALSE(stopped);
    CHECK_THAT(stopped.error().message, Catch::Contains("interrupted"));
}

}  // namespace
}  // namespace cambrian
