#include "pictures/preserve/world_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

ResidentPicture resident(double x, double store) {
    ResidentPicture picture;
    picture.life.number = 1;
    picture.center = {x, 0.0, 0.0};
    picture.store = store;
    picture.birth_need = 100.0;
    auto phenotype = std::make_shared<Phenotype>();
    picture.phenotype = phenotype;
    return picture;
}

// Returns the shapes that the energy of a creature in the middle of the view adds.
std::vector<Shape> ring_of(const ResidentPicture& resident) {
    PreservePicture picture;
    picture.area = {40.0, 25.0};
    picture.residents = {resident};
    const Palette palette = palette_of(ThemeKind::kDark);
    const Viewport viewport{800.0, 500.0};
    Camera camera;
    camera.fit({{-20.0, -12.5}, {20.0, 12.5}}, 1.0, viewport);
    SceneFrame without;
    add_world(without, palette, camera, viewport, picture, {});
    SceneFrame with;
    add_world(with, palette, camera, viewport, picture,
              {.picked = 0, .pins = {}, .energy = true, .look = LookMode::kLife});
    const auto more = static_cast<std::ptrdiff_t>(without.shapes.size());
    return {with.shapes.begin() + more, with.shapes.end()};
}

double length_of(const std::vector<Shape>& ring) {
    double length = 0.0;
    for (const Shape& each : ring)
        length += 2.0 * (each.half_extents.x() - each.half_extents.y());
    return length;
}

TEST_CASE("the ring of a creature is the longer and the greener the fuller its store is",
          "[pictures][preserve]") {
    const auto starving = ring_of(resident(0.0, 10.0));
    const auto half = ring_of(resident(0.0, 50.0));
    const auto full = ring_of(resident(0.0, 100.0));
    REQUIRE_FALSE(starving.empty());
    CHECK(length_of(half) == Approx(5.0 * length_of(starving)).epsilon(0.05));
    CHECK(length_of(full) == Approx(2.0 * length_of(half)).epsilon(0.05));
    CHECK(length_of(ring_of(resident(0.0, 300.0))) == length_of(full));
    CHECK(full.front().fill.g > half.front().fill.g);
    CHECK(half.front().fill.g > starving.front().fill.g);
    CHECK(starving.front().fill.r > full.front().fill.r);
    CHECK(ring_of(resident(30.0, 100.0)).empty());
}

// Returns a world with one creature, a box of 2 m at the right edge.
PreservePicture edge_world(bool wraps) {
    PreservePicture picture;
    picture.area = {40.0, 25.0, false, wraps};
    picture.residents = {resident(19.8, 10.0)};
    auto phenotype = std::make_shared<Phenotype>();
    phenotype->parts.resize(1);
    phenotype->plan.parts.resize(1);
    phenotype->plan.parts[0].half_extents = {1.0, 0.5, 0.0};
    picture.residents[0].phenotype = phenotype;
    picture.residents[0].parts = {{Vec3(19.8, 0.0, 0.0), Vec3::UnitX(), 1.0, 0.5}};
    return picture;
}

TEST_CASE("where edges meet, creatures near them are drawn and picked on both sides",
          "[pictures][preserve]") {
    const Palette palette = palette_of(ThemeKind::kDark);
    const Viewport viewport{800.0, 500.0};
    Camera camera;
    camera.fit({{-20.0, -12.5}, {20.0, 12.5}}, 1.0, viewport);
    const auto bodies_at = [&](const PreservePicture& picture, double x) {
        SceneFrame frame;
        add_world(frame, palette, camera, viewport, picture,
                  {.picked = 0, .pins = {}, .energy = false, .look = LookMode::kMechanics});
        return std::count_if(frame.shapes.begin(), frame.shapes.end(), [&](const Shape& shape) {
            return (shape.center - Vec2(x, 0.0)).norm() < 1e-9 &&
                   shape.half_extents == Vec2(1.0, 0.5);
        });
    };
    const PreservePicture wrapped = edge_world(true);
    const PreservePicture walled = edge_world(false);
    for (const PreservePicture* picture : {&wrapped, &walled})
        CHECK(bodies_at(*picture, 19.8) == 1);
    CHECK(bodies_at(wrapped, -20.2) == 1);
    CHECK(bodies_at(walled, -20.2) == 0);
    for (const Vec2& point : {Vec2(-19.5, 0.0), Vec2(59.9, 25.0), Vec2(19.5, 0.2)})
        CHECK(resident_at(wrapped, point, 0.1) == 1);
    CHECK(resident_at(walled, {-19.5, 0.0}, 0.1) == 0);
    CHECK(resident_at(wrapped, {0.0, 0.0}, 0.1) == 0);
    CHECK(image_near(wrapped.area, {19.0, 0.0}, {-19.0, 1.0}) == Vec2(-21.0, 0.0));
    CHECK(image_near(walled.area, {19.0, 0.0}, {-19.0, 1.0}) == Vec2(19.0, 0.0));
}

TEST_CASE("births and deaths are seen for a moment, where they were", "[pictures][preserve]") {
    PreservePicture picture;
    picture.area = {40.0, 25.0};
    picture.residents = {resident(3.0, 10.0)};
    picture.residents[0].life.born = 600;
    Life dead;
    dead.number = 7;
    dead.died = 660;
    dead.x = -5.0;
    dead.mass = 0.3;
    picture.died = std::make_shared<const std::vector<Life>>(std::vector{dead});
    Camera camera;
    camera.pixels_per_metre = 20.0;
    const auto near = [&](std::uint64_t tick, double x) {
        picture.tick = tick;
        SceneFrame frame;
        add_world(frame, palette_of(ThemeKind::kDark), camera, {800.0, 500.0}, picture, {});
        return std::count_if(frame.shapes.begin(), frame.shapes.end(), [&](const Shape& shape) {
            return (shape.center - Vec2(x, 0.0)).norm() < 1.5;
        });
    };
    const auto quiet = near(599, 3.0);
    CHECK(near(600, 3.0) > quiet + 5);
    CHECK(near(650, 3.0) > quiet + 5);
    CHECK(near(660, 3.0) == quiet);
    const auto alive = near(659, -5.0);
    CHECK(near(661, -5.0) > alive + 3);
    CHECK(near(800, -5.0) == alive);
}

TEST_CASE("the plants of a meadow stand on the ground, from wherever they are seen",
          "[pictures][preserve]") {
    PreservePicture picture;
    picture.area = {60.0, 8.0, true};
    Pellet plant;
    plant.x = 3.0;
    plant.y = 0.4;
    picture.plants = {plant};
    for (const double pixels_per_metre : {5.0, 50.0, 300.0}) {
        Camera camera;
        camera.center = {3.0, 0.2};
        camera.pixels_per_metre = pixels_per_metre;
        SceneFrame frame;
        add_world(frame, palette_of(ThemeKind::kDark), camera, {800.0, 500.0}, picture, {});
        const bool stands =
            std::any_of(frame.shapes.begin(), frame.shapes.end(), [&](const Shape& shape) {
                return std::fabs(shape.center.x() - 3.0) < 1e-9 &&
                       std::fabs(shape.center.y() - 0.2) < 1e-9 && shape.half_extents.x() >= 0.2 &&
                       2.0 * shape.half_extents.y() * pixels_per_metre >= 1.0;
            });
        INFO(pixels_per_metre);
        CHECK(stands);
    }
}

TEST_CASE("on hills, plants and what is scenery stand on the surface, also beyond joined edges",
          "[pictures][preserve]") {
    PreservePicture picture;
    picture.area = {60.0, 8.0, true, true};
    TerrainSettings terrain{.kind = "drawn", .points = "-9 0; -6 1; 6 1; 9 0"};
    terrain.world_width = 60.0;
    picture.area.ground = *Terrain::make(terrain);
    Pellet plant;
    plant.x = 3.0;
    plant.y = 1.4;
    picture.plants = {plant};
    for (const double middle : {3.0, -57.0}) {
        Camera camera;
        camera.center = {middle, 1.2};
        camera.pixels_per_metre = 50.0;
        SceneFrame frame;
        add_world(frame, palette_of(ThemeKind::kDark), camera, {800.0, 500.0}, picture, {});
        CHECK(frame.ground.at(middle) == Approx(1.0));
        CHECK(frame.ground.at(middle + 4.5) == Approx(0.5));
        const bool stands =
            std::any_of(frame.shapes.begin(), frame.shapes.end(), [&](const Shape& shape) {
                return std::fabs(shape.center.x() - middle) < 1e-9 &&
                       std::fabs(shape.center.y() - 1.2) < 1e-9 && shape.half_extents.x() >= 0.2;
            });
        CHECK(stands);
    }
}

TEST_CASE("living creatures are seen beyond joined edges, near and from afar",
          "[pictures][preserve]") {
    const Palette palette = palette_of(ThemeKind::kDark);
    const Viewport viewport{800.0, 500.0};
    const auto frame_at = [&](double pixels_per_metre, bool wraps) {
        Camera camera;
        camera.pixels_per_metre = pixels_per_metre;
        camera.center = {-20.0, 0.0};
        SceneFrame frame;
        add_world(frame, palette, camera, viewport, edge_world(wraps), {});
        return frame;
    };
    const auto is_image = [](const auto& body) {
        return (body.center - Vec2(-20.2, 0.0)).norm() < 1e-9 && body.half_extents.x() > 0.9;
    };
    for (const bool wraps : {false, true}) {
        const SceneFrame far = frame_at(20.0, wraps);
        CHECK(far.skins.empty());
        CHECK(std::any_of(far.shapes.begin(), far.shapes.end(), is_image) == wraps);
        const SceneFrame near = frame_at(80.0, wraps);
        CHECK(std::any_of(near.skin_boxes.begin(), near.skin_boxes.end(), is_image) == wraps);
        for (const Skin& skin : near.skins) {
            CHECK(skin.first_box + skin.boxes <= near.skin_boxes.size());
            CHECK(skin.shapes_below <= near.shapes.size());
        }
    }
}

}  // namespace
}  // namespace cambrian
