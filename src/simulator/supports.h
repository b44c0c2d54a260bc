#pragma once

// How far a body reaches along horizontal headings in space.

#include "math/types.h"
#include "world/body_view.h"

#include <array>
#include <cstddef>

namespace cambrian {

// Number k has the direction k * 22.5 degrees from x towards z; k + 8 is opposite to k.
inline constexpr std::size_t kHeadings = 16;

const std::array<Vec3, kHeadings>& headings();

// Of the corner that is farthest along each heading, m.
using Supports = std::array<double, kHeadings>;

Supports supports_of(const BodyView& body);

}  // namespace cambrian
