#pragma once

// The solids and marks of a frame of space as numbers for OpenGL, relative to the camera's target.

#include "math/types.h"
#include "render/space_frame.h"

#include <array>
#include <cstddef>
#include <vector>

namespace cambrian {

// Further solids neither cast nor receive shadows.
inline constexpr std::size_t kMostShading = 200;
inline constexpr std::size_t kBesideSolid = 8;  // boxes that may shade a solid
inline constexpr std::size_t kBoxFloats = 20;

using Floats3 = std::array<float, 3>;

inline Floats3 floats(const Vec3& from) {
    return {static_cast<float>(from.x()), static_cast<float>(from.y()),
            static_cast<float>(from.z())};
}

struct SolidInstance {
    std::array<float, 12> axes;  // of the solid, each with a number of its centre
    std::array<float, 4> size;
    std::array<float, 4> fill;
    std::array<float, 4> look;
    std::array<float, kBesideSolid> beside;  // numbers of boxes, -1 for none
};

struct MarkInstance {
    std::array<float, 4> disc;
    std::array<float, 4> fill;
    std::array<float, 2> edge;
};

// The solids that cast shadows, and kBoxFloats numbers of each.
struct ShadingBoxes {
    std::vector<std::size_t> solids;  // places in SpaceFrame::solids
    std::vector<float> numbers;
};

void list_boxes(const SpaceFrame& frame, ShadingBoxes& boxes);

enum class SolidsWanted : unsigned char { kOpaque, kSeeThrough };

// Returns the solids of a kind that are outlined or not: opaque ones from near to far, those that
// one sees through from far to near.
std::vector<SolidInstance> instances_of(const SpaceFrame& frame, const ShadingBoxes& shading,
                                        SolidsWanted wanted, bool inked);

}  // namespace cambrian
