#pragma once

// What the viewport shows of a creature in space: its camera, its scene, and what is drawn over it.

#include "pictures/scene/space_being.h"
#include "render/orbit_camera.h"
#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"

namespace cambrian {

class SpaceView {
public:
    // Moves the camera and pulls parts with the mouse over the item that was drawn last.
    void handle_mouse(const FrameContext& frame, const SceneCanvas& canvas, Requests& out);
    // Follows the displayed creature. `changed` tells that it is another one than before, `fit`
    // that it must fit the view.
    void place_camera(const FrameContext& frame, const SceneCanvas& canvas, bool changed, bool fit);
    // Fills the canvas with the scene, and sets its camera to that of the picture's plane.
    void build_scene(const FrameContext& frame, SceneCanvas& canvas) const;

    OrbitCamera& camera() { return orbit_; }
    const OrbitCamera& camera() const { return orbit_; }
    // Returns where the canvas has a point of the world, in the plane of its camera.
    Vec2 on_canvas(const Vec3& point, const SceneCanvas& canvas) const;

private:
    void handle_poke(const FrameContext& frame, const SceneCanvas& canvas, Requests& out);
    void add_overlays(const FrameContext& frame, const SpaceCamera& camera,
                      const CreatureLook& look, SceneFrame& scene) const;
    void look_from(ViewSide side);
    void stop_following(const FrameContext& frame, Requests& out) const;

    OrbitCamera orbit_;
    unsigned sides_seen_ = 0;  // number of LookFrom requests handled so far
    bool turning_ = false;     // the left button turns the view, since it met no part
    double grabbed_ = 0.0;     // m; distance of the grabbed point in front of the camera's target
};

}  // namespace cambrian
