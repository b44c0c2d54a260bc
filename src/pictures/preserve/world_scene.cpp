#include "pictures/preserve/world_scene.h"

#include "math/elementary.h"
#include "pictures/preserve/world_edges.h"
#include "pictures/scene/lit_color.h"
#include "pictures/scene/scene_builder.h"
#include "pictures/scene/scenery.h"
#include "pictures/scene/shaped_ground.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace cambrian {
namespace {

constexpr double kPlantRadius = 0.07;   // m
constexpr double kFinePlant = 4.0;      // pixels; smaller ones have one colour
constexpr double kLeastDot = 1.6;       // pixels
constexpr double kMostFlesh = 0.35;     // m
constexpr double kFleshOfJoule = 0.05;  // m; radius of 1 J
constexpr double kStalkWidth = 0.022;   // m
constexpr double kStalkPixels = 1.2;    // least width
constexpr double kLeaf = 0.09;          // m; how far a leaf reaches to its side
constexpr double kDeathShown = 1.8;     // s
const Color kPlantColor = color_of(0x2FA36B);
const Color kPatchColor = color_of(0xE8C468);
const Color kStalkColor = color_of(0x2C7A54);
const Color kFleshColor = color_of(0xC8553D);
const Color kDustColor = color_of(0xD8CFC4);

// Paints each patch as discs around its middle, so that it is brightest there.
void add_patches(SceneFrame& frame, const PreservePicture& picture) {
    for (const LightPatch& patch : picture.patches) {
        const Vec2 up(0.0, picture.area.ground_at(patch.center.x()));
        for (const double deviations : {2.0, 1.5, 1.0, 0.5})
            frame.add_circle(patch.center.head<2>() + up, deviations * patch.spread,
                             with_alpha(kPatchColor, 0.05F));
    }
}

void add_drawn_walls(SceneFrame& frame, const Palette& palette, const PreservePicture& picture) {
    for (const Rectangle& wall : picture.walls) {
        Shape shape = shape_of(wall);
        shape.radius = 0.0;
        shape.fill = palette.ground_line;
        shape.outline = palette.ground_line;
        frame.shapes.push_back(shape);
    }
}

// Stalks with two leaves each, which sway, and a fruit of two colours on top.
void add_plants(SceneFrame& frame, const Camera& camera, const PreservePicture& picture,
                double time) {
    const double width = std::max(kStalkWidth, kStalkPixels * camera.pixel());
    const double radius = std::max(kPlantRadius, kLeastDot * camera.pixel());
    const Color fruit = lit(kPlantColor, frame.light);
    const Color stalk = lit(kStalkColor, frame.light);
    const bool fine = kPlantRadius * camera.pixels_per_metre >= kFinePlant;
    for (const Pellet& plant : picture.plants) {
        const Vec2 top(plant.x, plant.y);
        if (picture.area.has_ground) {
            const double leaf = kLeaf + 0.015 * std::sin(1.3 * time + 3.0 * plant.x);
            const double foot = picture.area.ground_at(plant.x);
            const auto at = [&](double aside, double share) {
                return Vec2(plant.x + aside, foot + share * (plant.y - foot));
            };
            frame.add_line(at(0.0, 0.0), top, width, stalk);
            frame.add_line(at(0.0, 0.3), at(-leaf, 0.55), width, stalk);
            frame.add_line(at(0.0, 0.5), at(leaf, 0.75), width, stalk);
        }
        frame.add_circle(top, radius, fine ? mix(fruit, color_of(0x0A1A10), 0.45F) : fruit);
        if (!fine) continue;
        frame.add_circle(top, 0.80 * radius, fruit);
        frame.add_circle(top + Vec2(-0.24, 0.28) * radius, 0.30 * radius,
                         mix(fruit, color_of(0xFFFFE8), 0.45F));
    }
}

void add_food(SceneFrame& frame, const Camera& camera, const PreservePicture& picture,
              double time) {
    const double least = kLeastDot * camera.pixel();
    add_plants(frame, camera, picture, time);
    for (const Pellet& piece : picture.flesh) {
        const double size = kFleshOfJoule * std::sqrt(joules(piece.energy));
        const double radius = std::clamp(size, least, kMostFlesh);
        const double lift = picture.area.has_ground ? radius : 0.0;
        frame.add_circle({piece.x, piece.y + lift}, radius, kFleshColor);
    }
}

// Where one died, a cloud rises and fades.
void add_deaths(SceneFrame& frame, const Camera& camera, const PreservePicture& picture,
                const ShownWorld& world) {
    constexpr int kPuffs = 6;
    if (picture.died == nullptr) return;
    for (const Life& life : *picture.died) {
        const double age = world.seconds_since(life.died) / kDeathShown;
        if (age >= 1.0) continue;
        const double size = std::clamp(std::sqrt(life.mass), 5.0 * camera.pixel(), 1.5);
        const auto left = static_cast<float>((1.0 - age) * (1.0 - age));
        const Vec3 place = world.area.torus().shortest({life.x, life.y, 0.0});
        for (int i = 0; i < kPuffs; ++i) {
            const auto luck = [&](std::uint64_t use) {
                return chance(life.number, 80 + 4 * static_cast<std::uint64_t>(i) + use) - 0.5;
            };
            const Vec2 away(size * (0.9 + 0.6 * age) * luck(0), size * (0.7 * luck(1) + 0.7 * age));
            frame.add_glow(place.head<2>() + away, size * (0.35 + 0.4 * age + 0.2 * luck(2)),
                           with_alpha(kDustColor, 0.55F * left));
        }
    }
}

// Returns whether a creature or one of its images may be in the view.
bool in_view(const ResidentPicture& resident, const WorldWindow& window,
             std::span<const Vec2> shifts) {
    const double reach = reach_of(resident);
    return std::any_of(shifts.begin(), shifts.end(), [&](const Vec2& shift) {
        return in_view(resident.center.head<2>() + shift, reach, window);
    });
}

// Draws the store as a part of a ring, clockwise from the top.
void add_energy(SceneFrame& frame, const Palette& palette, const ResidentPicture& resident,
                double radius, double width) {
    const double share = std::clamp(resident.store / resident.birth_need, 0.0, 1.0);
    frame.add_arc(resident.center.head<2>(), radius, {0.5 * kPi, (0.5 - 2.0 * share) * kPi}, width,
                  mix(palette.danger, kPlantColor, static_cast<float>(share)));
}

void add_marks(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const WorldMarks& marks, const ResidentPicture& resident) {
    const Vec2 center = resident.center.head<2>();
    const double reach = reach_of(resident) + 5.0 * camera.pixel();
    const double width = 2.0 * camera.pixel();
    if (marks.energy) add_energy(frame, palette, resident, reach, 1.5 * width);
    if (marks.pins.contains(resident.life.number))
        frame.add_ring(center, reach + 2.0 * width, width, palette.text);
    if (marks.picked != resident.life.number) return;
    frame.add_ring(center, reach + 4.0 * width, 1.5 * width, palette.accent);
}

}  // namespace

void add_world(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const Viewport& viewport, const PreservePicture& picture, const WorldMarks& marks) {
    frame.background = palette.sky;
    const ShownWorld shown{marks.look, picture.area, picture.tick};
    const bool scenery = marks.scenery && marks.look != LookMode::kMechanics;
    use_ground(frame, picture.area.ground.get(), camera, viewport);
    if (scenery) {
        const DrawnWorld& world =
            drawn_world(world_kind_of(picture.laws->world.environment), *marks.scenery);
        if (picture.area.has_ground)
            add_scenery(frame, world, camera, viewport, shown.time());
        else
            use_world(frame, world);
    } else {
        add_grid(frame, palette, camera, viewport);
    }
    const WorldWindow window = camera.window(viewport);
    const std::vector<Vec2> shifts = image_shifts(picture.area);
    const std::size_t lowest = frame.shapes.size();
    add_patches(frame, picture);
    repeat_from(lowest, frame, window, shifts);
    if (!scenery && picture.area.ground) add_ground(frame, palette, camera, viewport);
    add_walls(frame, palette, camera, viewport, picture.area, scenery);
    const std::size_t first = frame.shapes.size();
    add_seams(frame, palette, camera, picture.area);
    add_drawn_walls(frame, palette, picture);
    add_food(frame, camera, picture, shown.time());
    for (const ResidentPicture& each : picture.residents) {
        if (!in_view(each, window, shifts)) continue;
        add_resident(frame, palette, camera, each, shown);
        add_marks(frame, palette, camera, marks, each);
    }
    add_deaths(frame, camera, picture, shown);
    repeat_from(first, frame, window, shifts);
}

Vec2 middle_of_view(const WorldArea& area, double height) {
    Vec2 middle = area.middle().head<2>();
    if (area.has_ground && height > area.height) middle.y() = (0.5 - kGroundShare) * height;
    return middle;
}

Vec2 image_near(const WorldArea& area, const Vec2& point, const Vec2& there) {
    if (!area.wraps) return point;
    const Vec3 way(point.x() - there.x(), point.y() - there.y(), 0.0);
    return there + area.torus().shortest(way).head<2>();
}

std::uint64_t resident_at(const PreservePicture& picture, const Vec2& point, double reach) {
    std::uint64_t nearest = 0;
    double least = reach;
    for (const ResidentPicture& each : picture.residents) {
        const Vec2 image = image_near(picture.area, point, each.center.head<2>());
        const Vec3 there(image.x(), image.y(), 0.0);
        double distance = (each.center - there).norm();
        for (const Rectangle& part : each.parts) {
            if (distance_to(part, there) == 0.0) distance = 0.0;
        }
        if (distance > least || (nearest != 0 && distance == least)) continue;
        nearest = each.life.number;
        least = distance;
    }
    return nearest;
}

}  // namespace cambrian
