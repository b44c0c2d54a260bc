#pragma once

// Overlays over a creature in space. They are drawn in the picture's plane, one metre of the frame
// being one pixel, and nothing hides them.

#include "render/space_camera.h"
#include "studio/panels/viewport/scene_overlays.h"

#include <span>

namespace cambrian {

// Returns where the frame has a point of the world.
inline Vec2 in_picture(const SpaceCamera& camera, const Vec3& point) {
    const Vec2 at = camera.look_at(point).place;
    return {at.x(), -at.y()};
}

// Adds a line between two points of the world, unless one is behind the camera.
void add_line(SceneFrame& frame, const SpaceCamera& camera, const Vec3& from, const Vec3& to,
              double pixels, const Color& color);

// The colours of the axes x, y and z.
const Color& axis_color(int axis);

// The edges of all parts, in their colours mixed with ink, faint where the part hides them.
void add_edges(SceneFrame& frame, const SpaceCamera& camera, const CreatureLook& look,
               const Color& ink);
// Draws each joint's axes in the colours of the part's own, and the joint itself as a dot. The axes
// of a ball are in the way of its limits.
void add_joint_axes(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over,
                    bool of_balls);
void add_joint_limits(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over);
void add_joint_torques(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over);
void add_sensor_readings(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over);
void add_contact_forces(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over);
// The centre of mass, with a plumb line to the ground if there is one.
void add_center_of_mass(SceneFrame& frame, const SpaceCamera& camera, const Vec3& center,
                        bool has_ground);
// The lines round the faces of a part that touch something.
void add_touched_faces(SceneFrame& frame, const SpaceCamera& camera, const CreatureLook& look,
                       const Color& color);

}  // namespace cambrian
