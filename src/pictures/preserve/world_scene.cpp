#include "pictures/preserve/world_scene.h"

#include "math/elementary.h"
#include "math/pose.h"
#include "pictures/scene/living_look.h"
#include "simulator/settings/trial_settings.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace cambrian {
namespace {

// Scales from which bodies have skins, eyes and organs, in pixels per metre.
constexpr double kDetailScale = 22.0;
constexpr double kLightDetailScale = 45.0;  // in light frames
constexpr double kPlantRadius = 0.07;       // m
constexpr double kFinePlant = 4.0;          // pixels; smaller ones have one colour
constexpr double kLeastDot = 1.6;           // pixels
constexpr double kMostFlesh = 0.35;         // m
constexpr double kFleshOfJoule = 0.05;      // m; radius of 1 J
constexpr double kStalkWidth = 0.022;       // m
constexpr double kStalkPixels = 1.2;        // least width
constexpr double kLeaf = 0.09;              // m; how far a leaf reaches to its side
constexpr double kWallPixels = 3.0;
constexpr double kBirthShown = 0.9;  // s for which a birth is seen
constexpr double kDeathShown = 1.8;  // s
constexpr double kBiteShown = 0.35;  // s for which the beginning of a bite is seen
constexpr double kMealShown = 0.15;  // s for which a mouth stays open
const Color kPlantColor = color_of(0x2FA36B);
const Color kPatchColor = color_of(0xE8C468);
const Color kStalkColor = color_of(0x2C7A54);
const Color kFleshColor = color_of(0xC8553D);
const Color kHatchColor = color_of(0xFFF1C4);
const Color kDustColor = color_of(0xD8CFC4);

// Paints what is beyond the walls and, unless scenery shows it, below the ground, and the walls.
void add_walls(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const Viewport& viewport, const WorldArea& area, bool scenery) {
    const WorldWindow window = camera.window(viewport);
    const double right = 0.5 * area.width;
    const double top = area.top();
    const double bottom = area.bottom();
    const double wall = kWallPixels * camera.pixel();
    const auto fill = [&](double x0, double y0, double x1, double y1, const Color& color) {
        const Vec2 low(std::max(x0, window.low.x() - wall), std::max(y0, window.low.y() - wall));
        const Vec2 high(std::min(x1, window.high.x() + wall), std::min(y1, window.high.y() + wall));
        if (low.x() < high.x() && low.y() < high.y())
            frame.add_box(0.5 * (low + high), 0.5 * (high - low), color);
    };
    constexpr double kFar = 1e6;
    const double end = area.has_sides() ? right : kFar;  // of the top and the bottom
    const bool has_floor = area.has_ground || area.has_bottom();
    if (area.has_sides()) {
        fill(-kFar, -kFar, -right, kFar, palette.window);
        fill(right, -kFar, kFar, kFar, palette.window);
    }
    // Above a meadow is more of its sky.
    const bool open_sky = scenery && area.has_ground;
    if (area.has_top() && !open_sky) fill(-kFar, top, kFar, kFar, palette.window);
    if (has_floor && !(scenery && area.has_ground))
        fill(-kFar, -kFar, kFar, bottom, area.has_ground ? palette.ground : palette.window);
    if (area.has_sides()) {
        fill(-right - wall, bottom - wall, -right, top + wall, palette.ground_line);
        fill(right, bottom - wall, right + wall, top + wall, palette.ground_line);
    }
    if (area.has_top() && !open_sky) fill(-end, top, end, top + wall, palette.ground_line);
    if (has_floor && !(scenery && area.has_ground))
        fill(-end, bottom - wall, end, bottom, palette.ground_line);
}

// Marks where edges meet by thin lines: the left and the lower edge, of which the others are
// images.
void add_seams(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const WorldArea& area) {
    const Vec2 corner(area.left(), area.bottom());
    const auto line = [&](const Vec2& to) {
        frame.add_line(corner, to, camera.pixel(), palette.ground_line);
    };
    if (!area.has_sides()) line({area.left(), area.top()});
    if (!area.has_top()) line({-area.left(), area.bottom()});
}

// Returns how far the images of the world that are drawn are from it. The first one is its own.
std::vector<Vec2> image_shifts(const WorldArea& area) {
    const Torus torus = area.torus();
    std::vector<Vec2> shifts = {Vec2::Zero()};
    for (std::int32_t y = -1; y <= 1; ++y) {
        for (std::int32_t x = -1; x <= 1; ++x) {
            const Vec3 shift = torus.shift_of({x, y});
            const bool is_image = (x == 0 || shift.x() != 0.0) && (y == 0 || shift.y() != 0.0);
            if (is_image && (x != 0 || y != 0)) shifts.push_back(shift.head<2>());
        }
    }
    return shifts;
}

bool in_view(const Vec2& center, double reach, const WorldWindow& window) {
    return center.x() + reach > window.low.x() && center.x() - reach < window.high.x() &&
           center.y() + reach > window.low.y() && center.y() - reach < window.high.y();
}

// Adds a skin again, moved, if it is in view there.
void repeat_skin(SceneFrame& frame, Skin skin, const Vec2& shift, const WorldWindow& window) {
    const std::size_t end = skin.first_box + skin.boxes;
    const auto seen = [&](std::size_t box) {
        const SkinBox& each = frame.skin_boxes[box];
        return in_view(each.center + shift, each.half_extents.norm() + skin.blend, window);
    };
    bool any = false;
    for (std::size_t box = skin.first_box; box < end; ++box)
        any = any || seen(box);
    if (!any) return;
    for (std::size_t box = skin.first_box; box < end; ++box) {
        SkinBox moved = frame.skin_boxes[box];
        moved.center += shift;
        frame.skin_boxes.push_back(moved);
    }
    frame.add_skin(skin);
}

// Adds the shapes from this one on, and the skins over them, again in each image of the world,
// where they are in view.
void repeat_from(std::size_t first, SceneFrame& frame, const WorldWindow& window,
                 std::span<const Vec2> shifts) {
    const std::size_t end = frame.shapes.size();
    const std::size_t skins = frame.skins.size();
    for (const Vec2& shift : shifts.subspan(1)) {
        std::size_t skin = 0;
        const auto repeat_skins_below = [&](std::size_t shape) {
            for (; skin < skins && frame.skins[skin].shapes_below <= shape; ++skin) {
                if (frame.skins[skin].shapes_below >= first)
                    repeat_skin(frame, frame.skins[skin], shift, window);
            }
        };
        for (std::size_t i = first; i < end; ++i) {
            repeat_skins_below(i);
            Shape shape = frame.shapes[i];
            shape.center += shift;
            const double reach = shape.half_extents.norm() + shape.blur;
            if (in_view(shape.center, reach, window)) frame.shapes.push_back(shape);
        }
        repeat_skins_below(end);
    }
}

double angle_of(const Rectangle& part) {
    return std::atan2(part.axis.y(), part.axis.x());
}

Shape shape_of(const Rectangle& part) {
    Shape shape;
    shape.center = part.center.head<2>();
    shape.half_extents = {part.half_length, part.half_width};
    shape.angle = angle_of(part);
    shape.radius = 0.45 * std::min(part.half_length, part.half_width);
    return shape;
}

// What all creatures of a picture have in common.
struct ShownWorld {
    LookMode mode = LookMode::kLife;
    const WorldArea& area;
    std::uint64_t tick = 0;

    double time() const { return static_cast<double>(tick) * kBrainTick; }  // s
    double seconds_since(std::uint64_t when) const {
        return when > tick ? 1e9 : static_cast<double>(tick - when) * kBrainTick;
    }
};

Character character_in(const ResidentPicture& resident, const ShownWorld& world) {
    constexpr double kTelling = 0.3;  // body sizes from its birthplace, which tell its way
    Character character;
    character.line = resident.life.lineage;
    character.walks = world.area.has_ground;
    character.time = world.time() + static_cast<double>(resident.life.number % 7) * 0.5;
    const double size = body_size(*resident.phenotype);
    const Vec3 born(resident.life.x, resident.life.y, 0.0);
    const double gone = world.area.torus().shortest(resident.center - born).x();
    if (character.walks && gone < -kTelling * size) character.way = {-1.0, 0.0};
    look_along(character, resident.velocity.head<2>(), size);
    return character;
}

void add_simple_body(SceneFrame& frame, const Palette& palette, const Camera& camera,
                     const ResidentPicture& resident, double hue) {
    for (std::size_t i = resident.parts.size(); i-- > 0;) {
        Shape shape = shape_of(resident.parts[i]);
        shape.outline_width = std::max(camera.pixel(), 0.008);
        shape.fill = part_color(resident.phenotype->parts[i], hue);
        shape.outline =
            resident.bitten ? palette.danger : mix(shape.fill, color_of(0x000000), 0.38F);
        frame.shapes.push_back(shape);
    }
}

// Draws a body as a dark shape with a coloured inside, the cheapest picture of one skin.
void add_small_body(SceneFrame& frame, const Palette& palette, const Camera& camera,
                    const ResidentPicture& resident, double hue) {
    for (const bool inside : {false, true}) {
        for (std::size_t i = resident.parts.size(); i-- > 0;) {
            Shape shape = shape_of(resident.parts[i]);
            const Color color =
                skin_color(resident.phenotype->parts[i], hue, resident.life.lineage);
            const double grown = (inside ? -0.5 : 0.7) * camera.pixel();
            shape.half_extents = (shape.half_extents + Vec2::Constant(grown))
                                     .cwiseMax(Vec2::Constant(0.45 * camera.pixel()));
            shape.radius = 0.62 * shape.half_extents.minCoeff();
            shape.fill = inside            ? color
                         : resident.bitten ? palette.danger
                                           : mix(color, color_of(0x100A0C), 0.78F);
            frame.shapes.push_back(shape);
        }
    }
}

// A ring grows where a bite begins. Boxes have a red outline as long as it lasts; a skin has its
// own.
void add_bite(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const ResidentPicture& resident, const ShownWorld& world) {
    const double age = world.seconds_since(resident.bitten_since) / kBiteShown;
    if (age < 1.0) {
        frame.add_ring(resident.center.head<2>(), (0.4 + 0.7 * age) * reach_of(resident),
                       2.0 * camera.pixel(),
                       with_alpha(palette.danger, static_cast<float>(0.9 * (1.0 - age))));
    }
    if (world.mode == LookMode::kLife) return;
    for (const Rectangle& part : resident.parts) {
        Shape shape = shape_of(part);
        shape.outline_width = 2.0 * camera.pixel();
        shape.fill = with_alpha(palette.danger, 0.0F);
        shape.outline = palette.danger;
        frame.shapes.push_back(shape);
    }
}

void add_detailed_body(SceneFrame& frame, const Palette& palette, const Camera& camera,
                       const ResidentPicture& resident, double hue, const ShownWorld& world) {
    std::vector<Pose> poses;
    std::vector<double> stretches;
    for (std::size_t i = 0; i < resident.parts.size(); ++i) {
        const Rectangle& part = resident.parts[i];
        poses.push_back(planar_pose(part.center.x(), part.center.y(), angle_of(part)));
        const double rest = resident.phenotype->plan.parts[i].half_extents.x();
        stretches.push_back(std::log(part.half_length / rest));
    }
    CreatureLook look{
        .phenotype = *resident.phenotype, .poses = poses, .hue = hue, .stretches = stretches};
    look.mode = world.mode;
    look.bitten = resident.bitten;
    look.bites = resident.fed != 0 && world.seconds_since(resident.fed) < kMealShown;
    look.character = character_in(resident, world);
    add_being(frame, palette, camera, look);
    if (resident.bitten) add_bite(frame, palette, camera, resident, world);
}

// Paints each patch as discs around its middle, so that it is brightest there.
void add_patches(SceneFrame& frame, const PreservePicture& picture) {
    for (const LightPatch& patch : picture.patches) {
        for (const double deviations : {2.0, 1.5, 1.0, 0.5})
            frame.add_circle(patch.center.head<2>(), deviations * patch.spread,
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

// Returns a colour as it is in the light of a frame.
Color lit(const Color& color, const SkinLight& light) {
    const auto part = [](float of, float fill, float key) {
        return std::min(1.0F, of * (fill + 0.55F * key));
    };
    return {part(color.r, light.fill.r, light.key.r), part(color.g, light.fill.g, light.key.g),
            part(color.b, light.fill.b, light.key.b), color.a};
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
            frame.add_line({plant.x, 0.0}, top, width, stalk);
            frame.add_line({plant.x, 0.3 * plant.y}, {plant.x - leaf, 0.55 * plant.y}, width,
                           stalk);
            frame.add_line({plant.x, 0.5 * plant.y}, {plant.x + leaf, 0.75 * plant.y}, width,
                           stalk);
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

// Where a creature was born, a ring and shards of a shell fly apart.
void add_birth(SceneFrame& frame, const Camera& camera, const ResidentPicture& resident,
               const ShownWorld& world) {
    constexpr int kShards = 7;
    const double age = world.seconds_since(resident.life.born) / kBirthShown;
    if (resident.life.born == 0 || age >= 1.0) return;
    const auto left = static_cast<float>((1.0 - age) * (1.0 - age));
    const Vec2 center = resident.center.head<2>();
    const double reach = std::max(reach_of(resident), 4.0 * camera.pixel());
    frame.add_glow(center, 1.9 * reach, with_alpha(kHatchColor, 0.5F * left));
    frame.add_ring(center, (0.7 + 0.8 * age) * reach, std::max(0.06 * reach, 1.2 * camera.pixel()),
                   with_alpha(kHatchColor, 0.9F * left));
    for (int i = 0; i < kShards; ++i) {
        const double turn = chance(resident.life.number, 60 + static_cast<std::uint64_t>(i));
        const auto [sine, cosine] = sine_cosine(2.0 * kPi * (i + 0.6 * turn) / kShards);
        frame.add_circle(center + (0.6 + (0.6 + turn) * age) * reach * Vec2(cosine, sine),
                         std::max(0.05 * reach, 0.9 * camera.pixel()),
                         with_alpha(kHatchColor, left));
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
    add_walls(frame, palette, camera, viewport, picture.area, scenery);
    const std::size_t first = frame.shapes.size();
    add_seams(frame, palette, camera, picture.area);
    add_drawn_walls(frame, palette, picture);
    add_food(frame, camera, picture, shown.time());
    const double detail = frame.detail == Detail::kLight ? kLightDetailScale : kDetailScale;
    for (const ResidentPicture& each : picture.residents) {
        if (!in_view(each, window, shifts)) continue;
        const double hue = lineage_hue(each.life.lineage);
        add_birth(frame, camera, each, shown);
        if (camera.pixels_per_metre >= detail) {
            add_detailed_body(frame, palette, camera, each, hue, shown);
        } else if (marks.look == LookMode::kMechanics) {
            add_simple_body(frame, palette, camera, each, hue);
        } else {
            add_small_body(frame, palette, camera, each, hue);
        }
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

double lineage_hue(std::uint64_t lineage) {
    const double turns = 0.61803398875 * static_cast<double>(lineage % 100'000);
    return turns - static_cast<double>(static_cast<std::uint64_t>(turns));
}

double reach_of(const ResidentPicture& resident) {
    double reach = 0.0;
    for (const Rectangle& part : resident.parts) {
        const double half = std::hypot(part.half_length, part.half_width);
        reach = std::max(reach, (part.center - resident.center).norm() + half);
    }
    return reach;
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
