#pragma once

#include "world/body_view.h"

namespace cambrian {

// Returns a speed (m/s) that no point of the body exceeds; at most 200 m/s, at which bodies break
// anyway.
double fastest_point(const BodyView& body);

}  // namespace cambrian
