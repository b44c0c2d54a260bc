#pragma once

// What tests of drawing share.

#include "sketch/strokes.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <fmt/core.h>

#include <string>
#include <utility>

namespace cambrian::test {

inline const ExpressionSettings kExpression;
inline const SceneSettings kScene;

inline SketchRules rules() {
    return {creature_kinds(), kExpression, kScene};
}

inline BodySketch drawn(Genome genome) {
    return sketch_of(std::move(genome), rules());
}

inline void check_valid(const Genome& genome) {
    const auto faults = validate(genome, kind_catalog());
    INFO((faults.empty() ? std::string() : faults.front()));
    CHECK(faults.empty());
}

inline Vec2 far_end(const BodySketch& sketch, std::size_t part) {
    const PlannedPart& planned = sketch.body.plan.parts[part];
    return in_world(planned, {planned.half_extents.x(), 0.0});
}

// Draws a part with this far end.
inline Genome grown(const BodySketch& sketch, std::size_t parent, const Vec2& from, const Vec2& to,
                    MirrorSides mirror = MirrorSides::kNone) {
    auto result = grow_part(sketch, parent, {from, to, mirror}, rules());
    INFO((result ? std::string() : result.error().message));
    REQUIRE(result);
    check_valid(result->genome);
    return result->genome;
}

// Returns a lying body with a leg at its lower right, in the picture.
inline BodySketch body_with_leg() {
    const BodySketch body = drawn(first_part());
    return drawn(grown(body, 0, {0.25, -0.11}, {0.3, -0.5}));
}

}  // namespace cambrian::test
