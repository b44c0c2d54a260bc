#pragma once

#include "render/orbit_camera.h"
#include "studio/look/ui_context.h"

namespace cambrian {

inline constexpr float kGizmoSide = 92.0F;  // in units of 1/96 inch

// Draws the three axes as the camera sees them, about a place of the window. A click on an end
// looks along that axis, and a drag goes round the target.
void draw_axes_gizmo(OrbitCamera& camera, const ImVec2& middle);

}  // namespace cambrian
