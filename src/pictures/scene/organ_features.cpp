#include "pictures/scene/organ_features.h"

#include "pictures/scene/shown_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cambrian {
namespace {

constexpr double kLeastFeature = 3.0;  // pixels; smaller ones are left out
constexpr double kMostGill = 0.06;     // m
const Color kGullet = color_of(0x2A0F14);
const Color kTooth = color_of(0xFFF8E8);
const Color kFold = color_of(0x140C10);
const Color kFoldLight = color_of(0xFFF6E8);

// A part in its frame: x is along it.
struct FeaturedPart {
    const Pose& pose;
    Vec2 half;      // m, as it is shown
    double narrow;  // m, the smaller half extent

    Vec2 at(double x, double y) const { return transform(pose, {x, y, 0.0}).head<2>(); }
};

// A slot across the far end, with a tooth in each half of it.
void add_mouth(SceneFrame& frame, const FeaturedPart& part, double place, bool open, double pixel) {
    const double wide = 0.5 * part.half.y();
    const double gape = std::max((open ? 0.34 : 0.12) * std::min(wide, part.half.x()), 0.6 * pixel);
    const double x = place < 0.0 ? -part.half.x() + 1.15 * gape : part.half.x() - 1.15 * gape;
    Shape slot;
    slot.center = part.at(x, 0.0);
    slot.half_extents = {gape, wide};
    slot.angle = planar_angle(part.pose);
    slot.radius = std::min(gape, wide);
    slot.fill = kGullet;
    frame.shapes.push_back(slot);
    const double tooth = 0.5 * gape;
    if (tooth < 0.7 * pixel) return;
    const double root = place < 0.0 ? x + 0.55 * gape : x - 0.55 * gape;
    for (const double side : {-0.42, 0.42}) {
        Shape shape = slot;
        shape.center = part.at(root, side * wide);
        shape.half_extents = {tooth, std::min(0.8 * tooth, 0.2 * wide)};
        shape.radius = 0.45 * shape.half_extents.minCoeff();
        shape.fill = kTooth;
        frame.shapes.push_back(shape);
    }
}

// Two slits, bent towards the far end, each with light along its edge.
void add_gills(SceneFrame& frame, const FeaturedPart& part, double x, double pixel) {
    const double size = std::min(kMostGill, 0.55 * part.narrow);
    const double angle = planar_angle(part.pose);
    const double width = std::max(0.16 * size, 0.8 * pixel);
    for (const double along : {-0.9, -0.35}) {
        const auto arc = [&](double shift, const Color& color) {
            frame.add_arc(part.at(x + along * size + shift, 0.0), size,
                          {angle - 0.75, angle + 0.75}, width, color);
        };
        arc(-0.9 * width, with_alpha(kFoldLight, 0.20F));
        arc(0.0, with_alpha(kFold, 0.62F));
    }
}

void add_nostrils(SceneFrame& frame, const FeaturedPart& part, double x, double pixel) {
    const double radius = std::max(0.11 * std::min(part.narrow, 2.0 * kMostGill), 0.8 * pixel);
    for (const double side : {-1.0, 1.0}) {
        const Vec2 at = part.at(x, 2.1 * side * radius);
        frame.add_circle(at, 1.5 * radius, with_alpha(kFoldLight, 0.16F));
        frame.add_circle(at, radius, with_alpha(kFold, 0.72F));
    }
}

// Three folds across the part, which are nearer to each other when it is short.
void add_folds(SceneFrame& frame, const FeaturedPart& part, double pixel) {
    const double width = std::max(0.07 * part.narrow, 0.8 * pixel);
    const double reach = 0.74 * part.half.y();
    for (const double along : {-0.32, 0.0, 0.32}) {
        const double x = along * part.half.x();
        const auto fold = [&](double shift, const Color& color) {
            frame.add_line(part.at(x + shift, -reach), part.at(x + shift, reach), width, color);
        };
        fold(-width, with_alpha(kFoldLight, 0.16F));
        fold(0.0, with_alpha(kFold, 0.34F));
    }
}

}  // namespace

void add_organ_features(SceneFrame& frame, const CreatureLook& look, double pixel) {
    constexpr double kInward = 0.72;  // share of the way to an end that features at it have
    for (const GrownOrgan& organ : look.phenotype.organs) {
        const Vec2 half =
            shown_half_extents(look.phenotype.plan, look.stretches, organ.part).head<2>();
        const FeaturedPart part{look.poses[organ.part], half, half.minCoeff()};
        if (part.narrow < kLeastFeature * pixel) continue;
        const double x = kInward * organ.place * half.x();
        switch (organ.mark) {
            case OrganMark::kMouth:
                add_mouth(frame, part, organ.place, look.bites, pixel);
                break;
            case OrganMark::kArcs:
                add_gills(frame, part, x, pixel);
                break;
            case OrganMark::kDots:
                add_nostrils(frame, part, x, pixel);
                break;
            case OrganMark::kArrows:
                if (organ.deforms) add_folds(frame, part, pixel);
                break;
        }
    }
}

}  // namespace cambrian
