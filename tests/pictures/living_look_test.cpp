#include "pictures/scene/living_look.h"

#include "pictures/scene/moment.h"
#include "pictures/scene/organ_features.h"
#include "render/opengl/framebuffer.h"
#include "render/opengl/offscreen_context.h"
#include "render/opengl/pixels.h"
#include "render/renderer.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

Subject walking_crawler() {
    const CreatureDocument document{unjudged(test::crawler(test::kinds().creature.catalog))};
    ExperimentSettings settings;
    settings.world.trial.duration = 2.0;
    auto subject = subject_of(document, settings, "Crawler", test::kinds());
    REQUIRE(subject);
    return std::move(*subject);
}

CreatureLook look_of(const Subject& subject, const MotionFrame& frame, LookMode mode) {
    CreatureLook look{subject.phenotype(), frame.poses};
    look.stretches = frame.stretches;
    look.mode = mode;
    return look;
}

// The place of an eye with the body at rest.
Vec2 eye_at_rest(const Phenotype& phenotype, const Eyes& eyes, std::size_t which) {
    const Vec2& place = eyes.places[which];
    return transform(phenotype.plan.parts[eyes.part].rest_pose, {place.x(), place.y(), 0.0})
        .head<2>();
}

double part_angle(const Subject& subject, std::size_t part) {
    return planar_angle(subject.phenotype().plan.parts[part].rest_pose);
}

Vec2 middle_at_rest(const Phenotype& phenotype) {
    Vec2 sum = Vec2::Zero();
    for (const PlannedPart& part : phenotype.plan.parts)
        sum += part.rest_pose.position.head<2>();
    return sum / static_cast<double>(phenotype.plan.parts.size());
}

// OKLab (Ottosson 2020) of sRGB as seen with a deficiency of colour vision.
using Matrix = std::array<std::array<double, 3>, 3>;
// Machado, Oliveira & Fernandes 2009, severity 1, on linear RGB.
constexpr std::array<Matrix, 4> kVisions = {Matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                            Matrix{{{0.152286, 1.052583, -0.204868},
                                                    {0.114503, 0.786281, 0.099216},
                                                    {-0.003882, -0.048116, 1.051998}}},
                                            Matrix{{{0.367322, 0.860646, -0.227968},
                                                    {0.280085, 0.672501, 0.047413},
                                                    {-0.011820, 0.042940, 0.968881}}},
                                            Matrix{{{1.255528, -0.076749, -0.178779},
                                                    {-0.078411, 0.930809, 0.147602},
                                                    {0.004733, 0.691367, 0.303900}}}};

std::array<double, 3> seen_as(const Color& color, const Matrix& vision) {
    const auto linear = [](float value) {
        const auto x = static_cast<double>(value);
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    const std::array<double, 3> given = {linear(color.r), linear(color.g), linear(color.b)};
    std::array<double, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            rgb[i] += vision[i][k] * given[k];
        rgb[i] = std::clamp(rgb[i], 0.0, 1.0);
    }
    const auto [r, g, b] = rgb;
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double difference(const Color& a, const Color& b, const Matrix& vision) {
    const auto first = seen_as(a, vision);
    const auto second = seen_as(b, vision);
    return std::hypot(first[0] - second[0], first[1] - second[1], first[2] - second[2]);
}

TEST_CASE("eighteen lines differ in pattern or, for any vision, in colour", "[pictures][look]") {
    for (std::uint64_t a = 0; a < 18; ++a) {
        for (std::uint64_t b = a + 1; b < 18; ++b) {
            if (pattern_of(a) != pattern_of(b)) continue;
            for (int hue = 0; hue < 24; ++hue) {
                for (const Matrix& vision : kVisions) {
                    INFO(a << " and " << b << " at hue " << hue << " of 24");
                    CHECK(difference(skin_color({}, hue / 24.0, a), skin_color({}, hue / 24.0, b),
                                     vision) >= 0.06);
                }
            }
        }
    }
}

TEST_CASE("eyes are at the end that goes ahead", "[pictures][look]") {
    const Subject subject = walking_crawler();
    const Phenotype& phenotype = subject.phenotype();
    const Vec2 middle = middle_at_rest(phenotype);
    for (const bool walks : {true, false}) {
        for (const double side : {-1.0, 1.0}) {
            Character character;
            character.walks = walks;
            character.way = {side, 0.0};
            const Eyes eyes = eyes_of(phenotype, character);
            const Vec2 first = eye_at_rest(phenotype, eyes, 0);
            const Vec2 second = eye_at_rest(phenotype, eyes, 1);
            CHECK(side * (first.x() - middle.x()) > 0.0);
            if (walks) {
                CHECK(side * (first.x() - second.x()) > 0.0);
            } else {
                CHECK((first - second).norm() == Approx(1.96 * eyes.radii[0]));
            }
        }
        for (int turn = 0; turn < 12; ++turn) {
            Character character;
            character.walks = walks;
            character.way = {std::cos(turn * 0.5236), std::sin(turn * 0.5236)};
            const Eyes eyes = eyes_of(phenotype, character);
            const Vec2 half = phenotype.plan.parts[eyes.part].half_extents.head<2>();
            // At most their rims lie beyond the head.
            for (const Vec2& place : eyes.places)
                CHECK(((place.cwiseAbs() - half).array() < 0.5 * eyes.radii[0]).all());
        }
    }
}

TEST_CASE("a creature blinks for a moment every few seconds, not in step with other lines",
          "[pictures][look]") {
    int closed = 0, together = 0;
    for (int tick = 0; tick < 60 * 70; ++tick) {
        Character character;
        character.time = tick / 60.0;
        character.line = 3;
        const bool blink = blinks(character);
        character.line = 4;
        closed += blink ? 1 : 0;
        together += blink && blinks(character) ? 1 : 0;
    }
    CHECK(closed > 20 * 6);
    CHECK(closed < 20 * 10);
    CHECK(together < closed / 2);
}

TEST_CASE("a creature looks where it goes and sleeps where it stays", "[pictures][look]") {
    std::vector<Vec2> path(50, Vec2(1.0, 0.5));
    Character still;
    follow_path(still, path, {1.0, 0.5}, 1.0);
    CHECK(still.asleep);
    for (std::size_t i = 0; i < path.size(); ++i)
        path[i].y() += 0.05 * static_cast<double>(i);
    Character climbing;
    follow_path(climbing, path, {1.0, 3.0}, 1.0);
    CHECK_FALSE(climbing.asleep);
    CHECK(climbing.gaze.y() > 0.9);
}

TEST_CASE("a mouth opens at the end of its part, and its teeth are in it", "[pictures][look]") {
    const Subject subject = walking_crawler();
    Phenotype eater = subject.phenotype();
    eater.organs = {{.part = 0, .place = 1.0, .mark = OrganMark::kMouth}};
    const std::vector<Pose> poses(eater.parts.size(), planar_pose(0.0, 0.0, 0.0));
    CreatureLook look{eater, poses};
    const auto shapes = [&] {
        SceneFrame frame;
        add_organ_features(frame, look, 1e-3);
        REQUIRE(frame.shapes.size() == 3);
        return frame.shapes;
    };
    const std::vector<Shape> closed = shapes();
    look.bites = true;
    const std::vector<Shape> open = shapes();
    CHECK(open[0].half_extents.x() > 2.0 * closed[0].half_extents.x());
    const Vec2 half = eater.plan.parts[0].half_extents.head<2>();
    for (const std::vector<Shape>& mouth : {closed, open}) {
        CHECK(mouth[0].center.x() > 0.5 * half.x());
        CHECK(mouth[0].center.x() + mouth[0].half_extents.x() <= half.x());
        for (const std::size_t tooth : {1U, 2U})
            CHECK(((mouth[tooth].center - mouth[0].center).cwiseAbs().array() <
                   mouth[0].half_extents.array())
                      .all());
    }
}

TEST_CASE("a swimmer that turns looks where its head points", "[pictures][look]") {
    const Subject subject = walking_crawler();
    const auto pupil = [&](double angle) {
        std::vector<Pose> poses;
        for (const PlannedPart& part : subject.phenotype().plan.parts)
            poses.push_back(part.rest_pose);
        CreatureLook look{subject.phenotype(), poses};
        look.character.walks = false;
        const Eyes eyes = eyes_of(look.phenotype, look.character);
        poses[eyes.part] = planar_pose(0.0, 0.0, part_angle(subject, eyes.part) + angle);
        SceneFrame frame;
        add_being(frame, palette_of(ThemeKind::kDark), Camera{{0.0, 0.0}, 2000.0}, look);
        const std::size_t count = frame.shapes.size();  // ball, iris, pupil, light
        return Vec2(frame.shapes[count - 2].center - frame.shapes[count - 4].center).normalized();
    };
    CHECK(pupil(0.0).x() > 0.99);
    CHECK(pupil(1.5707963).y() > 0.99);
}

TEST_CASE("Mechanics shows boxes only, Life a skin with eyes, Glass both", "[pictures][look]") {
    const Subject subject = walking_crawler();
    const MotionFrame frame = subject.motion().at(1.0);
    const Palette palette = palette_of(ThemeKind::kDark);
    const Camera camera;
    SceneFrame boxes, mechanics, life, glass;
    add_creature(boxes, palette, camera, look_of(subject, frame, LookMode::kLife));
    add_being(mechanics, palette, camera, look_of(subject, frame, LookMode::kMechanics));
    add_being(life, palette, camera, look_of(subject, frame, LookMode::kLife));
    add_being(glass, palette, camera, look_of(subject, frame, LookMode::kGlass));
    CHECK(mechanics.skins.empty());
    REQUIRE(mechanics.shapes.size() == boxes.shapes.size());
    for (std::size_t i = 0; i < boxes.shapes.size(); ++i) {
        CHECK(mechanics.shapes[i].center == boxes.shapes[i].center);
        CHECK(mechanics.shapes[i].fill == boxes.shapes[i].fill);
    }
    REQUIRE(life.skins.size() == 1);
    CHECK(life.skins[0].boxes == subject.phenotype().parts.size());
    CHECK(life.skins[0].alpha == 1.0F);
    REQUIRE(glass.skins.size() == 1);
    CHECK(glass.skins[0].alpha < 1.0F);
    CHECK(glass.shapes.size() >= subject.phenotype().parts.size());
}

TEST_CASE("a skin touches the ground where its body does", "[pictures][look]") {
    auto context = OffscreenContext::create();
    REQUIRE(context);
    auto renderer = Renderer::create();
    REQUIRE(renderer);
    const Subject subject = walking_crawler();
    constexpr int kSide = 400;
    Camera camera;
    camera.pixels_per_metre = 200.0;
    for (const double time : {0.0, 0.7, 1.4}) {
        const MotionFrame frame = subject.motion().at(time);
        if (std::all_of(frame.touched.begin(), frame.touched.end(),
                        [](FaceSet faces) { return faces == 0; }))
            continue;
        camera.center = {frame.center_of_mass.x(), 0.8};
        SceneFrame scene;
        scene.background = color_of(0xFFFFFF);
        add_skin_of(scene, camera, look_of(subject, frame, LookMode::kLife), 1.0F);
        auto framebuffer = Framebuffer::create(kSide, kSide);
        REQUIRE(framebuffer);
        framebuffer->bind();
        (*renderer)->draw(scene, camera, {0, 0, kSide, kSide});
        const Image image = read_pixels(kSide, kSide);
        int lowest = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x)
                if (image.pixel(x, y)[1] < 128) lowest = y;
        }
        const double ground = camera.to_screen({0.0, 0.0}, {kSide, kSide}).y();
        const double allowed = std::max(2.0, 0.015 * 200.0 * body_size(subject.phenotype()));
        CHECK(std::fabs(lowest + 1 - ground) <= allowed);
    }
}

}  // namespace
}  // namespace cambrian
