#pragma once

// The poses of a simulated body between two ticks, for drawing at the display's rate.

#include "math/pose.h"
#include "world/body_view.h"

#include <vector>

namespace cambrian {

class ShownMotion {
public:
    // Sets the body at the next tick; the last one becomes the previous tick.
    void follow(const BodyView& body);
    // Sets the body with no previous tick, as after a restart.
    void jump_to(const BodyView& body);
    // Sets the displayed instant: 0 is the previous tick, 1 the last one.
    void show(double share);

    const std::vector<Pose>& poses() const { return shown_; }
    const std::vector<double>& stretches() const { return shown_stretches_; }
    Vec3 center() const { return shown_center_; }

private:
    void capture(const BodyView& body);

    std::vector<Pose> previous_;
    std::vector<Pose> current_;
    std::vector<Pose> shown_;
    std::vector<double> previous_stretches_;
    std::vector<double> current_stretches_;
    std::vector<double> shown_stretches_;
    Vec3 previous_center_ = Vec3::Zero();
    Vec3 current_center_ = Vec3::Zero();
    Vec3 shown_center_ = Vec3::Zero();
};

}  // namespace cambrian
