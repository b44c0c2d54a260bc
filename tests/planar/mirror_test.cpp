// A creature and its mirror image must move in the same way. A difference shows that the result
// depends on the order of rows, corners or pairs.

#include "planar/bodies.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/mirror_image.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

enum class Sense : bool { kSame, kMirrored };

// Returns the distance, in m, between the parts of two flailing creatures after 10 s. One of them
// may be mirrored.
double distance_between(const BodyPlan& plan, const BodyPlan& other, Sense sense,
                        const Environment& environment) {
    const double sign = sense == Sense::kMirrored ? -1.0 : 1.0;
    const auto scene = make_scene(plan, environment);
    const auto image = make_scene(other, environment);
    if (environment.has_ground) {
        stand_on_ground(*scene);
        stand_on_ground(*image);
    }
    for (int tick = 0; tick < 600; ++tick) {
        flail(*scene, plan, 2.0);
        for (std::size_t part = 1; part < plan.parts.size(); ++part)
            image->set_target(part, sign * scene->target(part));
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        REQUIRE(image->advance(kTestTick) == SceneStatus::kRunning);
    }
    double farthest = 0.0;
    for (std::size_t part = 0; part < plan.parts.size(); ++part) {
        Vec3 place = scene->part_pose(part).position;
        place.x() *= sign;
        farthest = std::fmax(farthest, (place - image->part_pose(part).position).norm());
    }
    return farthest;
}

double distance_from_image(const BodyPlan& plan, const Environment& environment, Flip flip) {
    return distance_between(plan, mirror_image(plan, flip), Sense::kMirrored, environment);
}

// Returns the distance that rounding of angles alone causes. The image of the image is the creature
// itself, with angles that differ in the last digit.
double distance_from_rounded(const BodyPlan& plan, const Environment& environment, Flip flip) {
    return distance_between(plan, mirror_image(mirror_image(plan, flip), flip), Sense::kSame,
                            environment);
}

using Distance = double (*)(const BodyPlan& plan, const Environment& environment, Flip flip);

// Returns the distances of several creatures, sorted.
std::vector<double> distances(Distance distance, int parts, int creatures,
                              const Environment& environment, Flip flip) {
    std::vector<double> all;
    for (int i = 0; i < creatures; ++i) {
        RandomStream random(
            stream_seed({static_cast<std::uint64_t>(parts), static_cast<std::uint64_t>(i), 73}));
        all.push_back(distance(random_tree(random, parts, 0.0, 20.0, 0.0), environment, flip));
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

// Negating angles changes only signs, without rounding. Half a turn minus an angle is rounded;
// frequent collisions amplify the difference, mirrored or not.
TEST_CASE("without ground mirror images do the same", "[dynamics][mirror]") {
    constexpr int kCreatures = test::by_build(6, 2);
    Environment air;
    air.has_ground = false;
    for (const Environment& environment : {air, empty_space(), open_water()}) {
        for (const int parts : {3, 6, 12, 24}) {
            for (const Flip flip : {Flip::kLength, Flip::kWidth}) {
                INFO("gravity " << environment.gravity << ", drag "
                                << environment.viscosity_quadratic << ", " << parts
                                << " parts, flip " << static_cast<int>(flip));
                const double rounding =
                    distances(distance_from_rounded, parts, kCreatures, environment, flip).back();
                CHECK(distances(distance_from_image, parts, kCreatures, environment, flip).back() <=
                      std::fmax(1e-11, 10.0 * rounding));
            }
        }
    }
}

TEST_CASE("on the ground mirror images do the same", "[dynamics][mirror]") {
    for (const int parts : {3, 6, 12}) {
        for (const Flip flip : {Flip::kLength, Flip::kWidth}) {
            const auto all = distances(distance_from_image, parts, 15, {}, flip);
            INFO(parts << " parts, flip " << static_cast<int>(flip));
            CHECK(all[all.size() / 2] <= 1e-9);
        }
    }
}
