#include "pictures/scene/space_being.h"

#include "pictures/scene/space_world.h"
#include "render/orbit_camera.h"

#include <catch2/catch.hpp>

namespace cambrian {
namespace {

constexpr Viewport kPicture{600.0, 400.0};

// A trunk and a tail behind it, at rest.
struct PlainSwimmer {
    PlainSwimmer() {
        for (const double x : {0.0, -0.9}) {
            PlannedPart part;
            part.half_extents = {0.4, 0.15, 0.2};
            part.rest_pose.position = {x, 0.0, 0.0};
            phenotype.plan.parts.push_back(part);
            BodyPart grown;
            grown.length = 0.8;
            grown.width = 0.3;
            grown.thickness = 0.4;
            phenotype.parts.push_back(grown);
            poses.push_back(part.rest_pose);
        }
        phenotype.plan.parts[1].parent = 0;
    }
    Phenotype phenotype;
    std::vector<Pose> poses;
};

}  // namespace

TEST_CASE("a ray meets the part in front, where its surface is", "[pictures][space]") {
    const PlainSwimmer swimmer;
    OrbitCamera orbit;
    for (const Vec3& side : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.4, 0.5, 0.6), Vec3(-1, 0, 0)}) {
        orbit.look_from(side);
        const SpaceCamera camera = orbit.seen(kPicture);
        const PartHit hit = part_at(swimmer.phenotype, swimmer.poses, camera,
                                    camera.look_at({0.1, 0.0, 0.0}).place);
        // From behind, the tail is in front of the trunk.
        CHECK(hit.part == (side.x() < -0.9 ? 1 : 0));
        const Pose& pose = swimmer.poses[static_cast<std::size_t>(hit.part)];
        const Vec3 inside = pose.orientation.conjugate() * Vec3(hit.place - pose.position);
        const Vec3& half = swimmer.phenotype.plan.parts[0].half_extents;
        CHECK((inside.cwiseAbs() - half).maxCoeff() == Approx(0.0).margin(1e-9));
        const Vec2 aside = camera.look_at(camera.target + 3.0 * camera.right).place;
        CHECK(part_at(swimmer.phenotype, swimmer.poses, camera, aside).part == -1);
    }
}

TEST_CASE("a creature in space lives in its pattern, with eyes that go ahead",
          "[pictures][space]") {
    const PlainSwimmer swimmer;
    CreatureLook look{swimmer.phenotype, swimmer.poses};
    look.character.line = 7;
    look.character.time = 0.5;
    const auto balls_ahead = [&](const Vec3& way) {
        SpaceFrame frame;
        add_being(frame, look, {.way = way});
        double sum = 0.0;
        for (std::size_t i = swimmer.poses.size(); i < frame.solids.size(); ++i)
            sum += frame.solids[i].pose.position.x();
        return sum / static_cast<double>(frame.solids.size() - swimmer.poses.size());
    };
    CHECK(balls_ahead({1.0, 0.0, 0.0}) > 0.25);
    CHECK(balls_ahead({-1.0, 0.0, 0.0}) < -1.1);

    SpaceFrame alive;
    add_being(alive, look, {});
    CHECK(alive.solids.size() > swimmer.poses.size());
    CHECK(alive.solids[0].pattern == pattern_of(7));
    look.mode = LookMode::kMechanics;
    SpaceFrame boxes;
    add_being(boxes, look, {});
    REQUIRE(boxes.solids.size() == swimmer.poses.size());
    CHECK(boxes.solids[0].pattern == SkinPattern::kPlain);
    CHECK(boxes.solids[0].radius < alive.solids[0].radius);
}

TEST_CASE("water has a floor that keeps away, and land the ground of its physics",
          "[pictures][space]") {
    Environment water;
    water.dimensions = 3;
    water.gravity = 0.0;
    water.has_ground = false;
    water.viscosity_quadratic = 1000.0;
    for (const double height : {5.0, 0.0, -40.0}) {
        SpaceFrame frame;
        OrbitCamera orbit;
        orbit.target.y() = height;
        frame.camera = orbit.seen(kPicture);
        use_space(frame, water, {});
        REQUIRE(frame.floor);
        CHECK(frame.floor->height < height - 1.0);
        CHECK_FALSE(frame.marks.empty());
    }
    Environment land;
    land.dimensions = 3;
    SpaceFrame frame;
    frame.camera = OrbitCamera{}.seen(kPicture);
    use_space(frame, land, {});
    REQUIRE(frame.floor);
    CHECK(frame.floor->height == 0.0);
    CHECK(frame.floor->lines.a > 0.0F);
}

}  // namespace cambrian
