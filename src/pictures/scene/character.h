#pragma once

// What makes a body a character: the pattern and lightness of its founder's line, and its eyes.

#include "creature/phenotype.h"
#include "render/skin.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cambrian {

// How a creature is seen: alive in its skin, as boxes through a pale skin, or as boxes only.
enum class LookMode : unsigned char { kLife, kGlass, kMechanics };

constexpr LookMode next_look(LookMode look) {
    return look == LookMode::kMechanics ? LookMode::kLife
                                        : static_cast<LookMode>(static_cast<int>(look) + 1);
}

// What is known of a displayed creature besides its body. All of it follows from the creature, its
// motion and the time, so that one moment has one picture.
struct Character {
    // Of its founder. Six successive lines have different patterns, eighteen differ in pattern or
    // lightness.
    std::uint64_t line = 0;
    // The parts' poses at the start of its test, which must outlive this; empty for those at rest.
    std::span<const Pose> posture = {};
    Vec2 way = Vec2(1.0, 0.0);  // direction in which it travels from there
    bool walks = true;          // on ground; otherwise it swims or flies
    // Where it looks, in the world; at most 1 long. The shorter, the more it looks ahead.
    Vec2 gaze = Vec2::Zero();
    double time = 0.0;  // s of its trial; it blinks now and then
    bool asleep = false;
};

struct Eyes {
    std::size_t part = 0;
    std::array<Vec2, 2> places = {Vec2::Zero(), Vec2::Zero()};  // in the part's frame at rest, m
    std::array<double, 2> radii = {0.0, 0.0};                   // m
};

// Returns the side of a square as large as all parts, in m. Sizes of features follow it.
double body_size(const Phenotype& phenotype);

// Returns where a creature's eyes are: at the end that goes ahead of the body in its posture. On
// ground they are at its upper corner, one behind the other, otherwise side by side.
Eyes eyes_of(const Phenotype& phenotype, const Character& character);

// Returns a number in [0, 1) that looks random: always the same for a number and a purpose.
double chance(std::uint64_t number, std::uint64_t purpose);

bool blinks(const Character& character);

// Returns the direction of travel of a creature that moved by this much in its trial, in m.
Vec2 way_of(const Vec2& travelled, bool walks);
// Lets a creature look along its way, and sleep where it rests. `path` has the last places of its
// centre of mass, oldest first, fifteen a second; `here` is the present one.
void follow_path(Character& character, std::span<const Vec2> path, const Vec2& here, double size);
inline constexpr std::size_t kPathPoints = 48;  // that follow_path() uses at most
void look_at(Character& character, const Vec2& from, const Vec2& target);
// Lets it look along its velocity (m/s), the more the faster it is for its size (m).
void look_along(Character& character, const Vec2& velocity, double size);

SkinPattern pattern_of(std::uint64_t line);
// Returns the length of a wave of the pattern as a share of body_size().
double wave_of(std::uint64_t line);

// Returns the colour of a part's skin: the lineage's hue (in turns) with a small shift for each
// gene node, in the lightness of its line.
Color skin_color(const BodyPart& part, double hue, std::uint64_t line);

// Returns the line of a creature: that of its founder or, if that is unknown (0), one that its hue
// chooses.
std::uint64_t line_or_hue(std::uint64_t line, double hue);

}  // namespace cambrian
