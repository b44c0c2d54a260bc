// A creature and its mirror image must do the same. What differs depends on the order of rows,
// corners or pairs instead of on the physics.

#include "dynamics/bodies.h"
#include "support/catch.h"
#include "support/mirror_image.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

// m, by which the parts of a flailing creature and of its image are apart after 10 s.
double distance_from_image(const BodyPlan& plan, const Environment& environment, Flip flip) {
    const auto scene = make_scene(plan, environment);
    const auto image = make_scene(mirror_image(plan, flip), environment);
    if (environment.has_ground) {
        stand_on_ground(*scene);
        stand_on_ground(*image);
    }
    for (int tick = 0; tick < 600; ++tick) {
        flail(*scene, plan, 2.0);
        for (std::size_t part = 1; part < plan.parts.size(); ++part)
            image->set_target(part, -scene->target(part));
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        REQUIRE(image->advance(kTestTick) == SceneStatus::kRunning);
    }
    double farthest = 0.0;
    for (std::size_t part = 0; part < plan.parts.size(); ++part) {
        Vec3 place = scene->part_pose(part).position;
        place.x() = -place.x();
        farthest = std::fmax(farthest, (place - image->part_pose(part).position).norm());
    }
    return farthest;
}

// Of several creatures, sorted.
std::vector<double> distances(int parts, int creatures, const Environment& environment, Flip flip) {
    std::vector<double> all;
    for (int i = 0; i < creatures; ++i) {
        RandomStream random(
            stream_seed({static_cast<std::uint64_t>(parts), static_cast<std::uint64_t>(i), 73}));
        const BodyPlan plan = random_tree(random, parts, 0.0, 20.0, 0.0);
        all.push_back(distance_from_image(plan, environment, flip));
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

// m. Angles reversed give the same numbers but for signs. Half turns minus angles are rounded, and
// so are places far down after a fall: what knocks together often makes more of that.
double allowed_distance(const Environment& environment, int parts, Flip flip) {
    const bool falls = environment.gravity > 0.0;
    return flip == Flip::kWidth && parts > (falls ? 6 : 12) ? 1e-8 : 1e-11;
}

TEST_CASE("without ground mirror images do the same", "[dynamics][mirror]") {
    Environment air;
    air.has_ground = false;
    for (const Environment& environment : {air, empty_space(), open_water()}) {
        for (const int parts : {3, 6, 12, 24}) {
            for (const Flip flip : {Flip::kLength, Flip::kWidth}) {
                INFO("gravity " << environment.gravity << ", drag "
                                << environment.viscosity_quadratic << ", " << parts
                                << " parts, flip " << static_cast<int>(flip));
                CHECK(distances(parts, 6, environment, flip).back() <=
                      allowed_distance(environment, parts, flip));
            }
        }
    }
}

TEST_CASE("on the ground mirror images do the same", "[dynamics][mirror]") {
    for (const int parts : {3, 6, 12}) {
        for (const Flip flip : {Flip::kLength, Flip::kWidth}) {
            const auto all = distances(parts, 15, {}, flip);
            INFO(parts << " parts, flip " << static_cast<int>(flip));
            CHECK(all[all.size() / 2] <= 1e-9);
        }
    }
}
