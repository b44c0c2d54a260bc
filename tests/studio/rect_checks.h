#pragma once

// Checks whether a rectangle of the layout is inside a window of that size.

#include "studio/layout.h"

namespace cambrian::test {

inline bool inside(const Rect& rect, float width, float height) {
    return rect.x >= 0 && rect.y >= 0 && rect.x + rect.width <= width &&
           rect.y + rect.height <= height;
}

}  // namespace cambrian::test
