#pragma once

#include "world/body_view.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// A set of faces of one part, one bit per face.
using FaceSet = std::uint8_t;

constexpr FaceSet face_bit(Face face) {
    return static_cast<FaceSet>(1U << static_cast<unsigned>(face));
}

// Returns for every part the faces that touched something during the last tick.
std::vector<FaceSet> touched_faces(const BodyView& body);

}  // namespace cambrian
