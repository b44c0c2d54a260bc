#include "pictures/scene/scene_builder.h"

#include "pictures/scene/bout_scene.h"
#include "pictures/scene/follow_camera.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

const Palette kPalette = palette_of(ThemeKind::kDark);
const Camera kCamera{.center = {0.0, 0.5}, .pixels_per_metre = 100.0};
constexpr Viewport kView{800.0, 600.0};

Phenotype grown_crawler() {
    const auto genome = test::crawler(test::kinds().creature.catalog);
    return express(*genome, test::kinds().creature, {}, {});
}
std::vector<Pose> rest_poses(const Phenotype& phenotype) {
    std::vector<Pose> poses;
    for (const PlannedPart& part : phenotype.plan.parts)
        poses.push_back(part.rest_pose);
    return poses;
}

TEST_CASE("organs have signs inside their parts", "[pictures][scene_builder]") {
    const KindCatalog& catalog = test::kinds().creature.catalog;
    Genome genome = *test::crawler(catalog);
    const auto shapes_of = [&] {
        const Phenotype phenotype = express(genome, test::kinds().creature, {}, {});
        SceneFrame frame;
        add_creature(frame, kPalette, kCamera, {phenotype, rest_poses(phenotype)});
        return frame.shapes;
    };
    const auto plain = shapes_of();
    for (std::size_t kind = 0; kind < catalog.organs.size(); ++kind) {
        genome.nodes[0].organs = {{.kind = static_cast<std::uint8_t>(kind)}};
        const auto marked = shapes_of();
        INFO(catalog.organs[kind].id);
        REQUIRE(marked.size() > plain.size() + 2);
        const Vec2 half(0.4, 0.1);
        for (const Shape& shape : marked) {
            const bool is_new = std::none_of(plain.begin(), plain.end(), [&](const Shape& each) {
                return each.center == shape.center && each.half_extents == shape.half_extents;
            });
            if (!is_new) continue;
            CHECK(shape.half_extents.maxCoeff() < half.y());
            CHECK(std::fabs(shape.center.x()) < half.x());
            CHECK(std::fabs(shape.center.y()) < half.y());
        }
    }
}

TEST_CASE("every part is drawn at its pose in its size", "[pictures][scene_builder]") {
    const Phenotype phenotype = grown_crawler();
    const auto poses = rest_poses(phenotype);
    SceneFrame frame;
    add_creature(frame, kPalette, kCamera, {phenotype, poses});
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const auto& part = phenotype.plan.parts[i];
        const bool drawn =
            std::any_of(frame.shapes.begin(), frame.shapes.end(), [&](const Shape& shape) {
                return (shape.center - poses[i].position.head<2>()).norm() < 1e-9 &&
                       (shape.half_extents - part.half_extents.head<2>()).norm() < 1e-9;
            });
        CHECK(drawn);
    }
}

TEST_CASE("the root is drawn over its limbs and each moving joint has a pivot",
          "[pictures][scene_builder]") {
    const Phenotype phenotype = grown_crawler();
    const auto poses = rest_poses(phenotype);
    SceneFrame frame;
    add_creature(frame, kPalette, kCamera, {phenotype, poses});
    const std::size_t parts = phenotype.parts.size();
    CHECK(frame.shapes.size() == parts + 2 * phenotype.effectors.size());
    CHECK((frame.shapes[parts - 1].center - poses[0].position.head<2>()).norm() < 1e-9);
}

TEST_CASE("a highlighted node highlights every part grown from it", "[pictures][scene_builder]") {
    const Phenotype phenotype = grown_crawler();
    const auto poses = rest_poses(phenotype);
    SceneFrame plain;
    SceneFrame lit;
    add_creature(plain, kPalette, kCamera, {phenotype, poses});
    add_creature(lit, kPalette, kCamera, {phenotype, poses, {}, 0.0, {.node = 1}});
    std::ptrdiff_t changed = 0;
    for (std::size_t i = 0; i < plain.shapes.size(); ++i)
        changed += plain.shapes[i].fill == lit.shapes[i].fill ? 0 : 1;
    const auto of_node = std::count_if(phenotype.parts.begin(), phenotype.parts.end(),
                                       [](const BodyPart& part) { return part.node == 1; });
    CHECK(changed == of_node);
}

TEST_CASE("the part under a point is found, and none beside the body",
          "[pictures][scene_builder]") {
    const Phenotype phenotype = grown_crawler();
    const auto poses = rest_poses(phenotype);
    CHECK(part_at(phenotype, poses, poses[0].position.head<2>()) == 0);
    CHECK(part_at(phenotype, poses, {50.0, 50.0}) == -1);
}

TEST_CASE("marks are at 1, 2 or 5 times a power of ten, far enough apart",
          "[pictures][scene_builder]") {
    for (double scale = 5.0; scale < 4000.0; scale *= 1.3) {
        const Camera camera{.pixels_per_metre = scale};
        const double spacing = mark_spacing(camera, 60.0);
        CHECK(spacing * scale >= 60.0 * (1.0 - 1e-12));
        CHECK(spacing * scale <= 60.0 * 2.5 * (1.0 + 1e-12));
    }
}

TEST_CASE("the window of a contest has the creature, the cube and the opponent",
          "[pictures][scene_builder]") {
    const Phenotype phenotype = grown_crawler();
    const auto poses = rest_poses(phenotype);
    auto far_poses = poses;
    for (Pose& pose : far_poses)
        pose.position.x() += 9.0;
    BoutLook look;
    look.cube.position.x() = 4.0;
    const WorldWindow body = body_window(phenotype, poses);
    const WorldWindow with_cube = with_bout(body, look);
    CHECK(with_cube.low.x() == body.low.x());
    CHECK(with_cube.high.x() > 4.0);
    CHECK(with_cube.high.x() < 5.0);
    look.opponent = &phenotype;
    look.poses = far_poses;
    CHECK(with_bout(body, look).high.x() == Approx(body.high.x() + 9.0));
}

TEST_CASE("an opponent of the same lineage has another colour", "[pictures][scene_builder]") {
    CHECK(apart_from(0.2, 0.7) == 0.7);
    CHECK(apart_from(0.2, 0.2) == Approx(0.7));
    CHECK(apart_from(0.95, 0.02) == Approx(0.45));
    CHECK(apart_from(0.95, 0.2) == 0.2);
}

TEST_CASE("no ground is drawn when it is out of sight", "[pictures][scene_builder]") {
    SceneFrame frame;
    const Camera high{.center = {0.0, 100.0}};
    add_ground(frame, kPalette, high, kView);
    CHECK(frame.shapes.empty());
    add_ground(frame, kPalette, kCamera, kView);
    CHECK_FALSE(frame.shapes.empty());
}

}  // namespace
}  // namespace cambrian
