#pragma once

// The surface of a box with round edges, for any size: each vertex has the signs of its corner and
// the normal there.

#include <array>
#include <vector>

namespace cambrian {

struct BoxVertex {
    std::array<float, 3> corner;  // -1 or 1
    std::array<float, 3> normal;  // of length 1
};

struct BoxMesh {
    std::vector<BoxVertex> vertices;
    std::vector<unsigned> triangles;  // three vertices each, counter-clockwise from outside
};

// The point of a vertex is corner * (half extents - radius) + normal * radius. A quarter of a round
// edge has twice as many steps as `steps`.
BoxMesh rounded_box(int steps);

}  // namespace cambrian
