#pragma once

// Where the parts of a simulated body are between two ticks, for drawing at the display's rate.

#include "math/pose.h"
#include "world/body_view.h"

#include <vector>

namespace cambrian {

class ShownMotion {
public:
    // The body a tick later; what it was before is the tick before.
    void follow(const BodyView& body);
    // The body as it is, with nothing before it.
    void jump_to(const BodyView& body);
    // The moment shown: 0 is the tick before, 1 the last.
    void show(double share);

    const std::vector<Pose>& poses() const { return shown_; }
    Vec3 center() const { return shown_center_; }

private:
    void capture(const BodyView& body);

    std::vector<Pose> previous_;
    std::vector<Pose> current_;
    std::vector<Pose> shown_;
    Vec3 previous_center_ = Vec3::Zero();
    Vec3 current_center_ = Vec3::Zero();
    Vec3 shown_center_ = Vec3::Zero();
};

}  // namespace cambrian
