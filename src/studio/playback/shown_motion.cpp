#include "studio/playback/shown_motion.h"

#include <algorithm>
#include <utility>

namespace cambrian {

void ShownMotion::capture(const BodyView& body) {
    current_.resize(body.part_count());
    current_stretches_.resize(body.part_count());
    for (std::size_t part = 0; part < current_.size(); ++part) {
        current_[part] = body.part_pose(part);
        current_stretches_[part] = body.stretch(part);
    }
    current_center_ = body.center_of_mass();
}

void ShownMotion::follow(const BodyView& body) {
    std::swap(previous_, current_);
    std::swap(previous_stretches_, current_stretches_);
    previous_center_ = current_center_;
    capture(body);
}

void ShownMotion::jump_to(const BodyView& body) {
    capture(body);
    previous_ = current_;
    previous_stretches_ = current_stretches_;
    previous_center_ = current_center_;
    show(1.0);
}

void ShownMotion::show(double share) {
    const double inside = std::clamp(share, 0.0, 1.0);
    shown_.resize(current_.size());
    shown_stretches_.resize(current_.size());
    for (std::size_t part = 0; part < current_.size(); ++part) {
        const Pose& from = previous_[part];
        const Pose& to = current_[part];
        shown_[part].position = from.position + inside * (to.position - from.position);
        shown_[part].orientation = from.orientation.slerp(inside, to.orientation);
        const double stretch = previous_stretches_[part];
        shown_stretches_[part] = stretch + inside * (current_stretches_[part] - stretch);
    }
    shown_center_ = previous_center_ + inside * (current_center_ - previous_center_);
}

}  // namespace cambrian
