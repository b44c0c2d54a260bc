#include "app/motion_trace.h"

#include "core/number_text.h"

namespace cambrian {

MotionTrace::MotionTrace(const Trial& trial) : csv_("time,mass_x,mass_y") {
    for (std::size_t part = 0; part < trial.scene().part_count(); ++part) {
        const std::string name = ",part" + std::to_string(part);
        for (const char* quantity : {"_x", "_y", "_angle", "_joint"})
            csv_.append(name).append(quantity);
    }
    csv_ += '\n';
}

void MotionTrace::add(const Trial& trial) {
    const PhysicsScene& scene = trial.scene();
    const auto cell = [this](double number) { csv_ += "," + short_text(number); };
    csv_ += short_text(trial.time());
    const Vec3 center = scene.center_of_mass();
    cell(center.x());
    cell(center.y());
    for (std::size_t part = 0; part < scene.part_count(); ++part) {
        const Pose pose = scene.part_pose(part);
        cell(pose.position.x());
        cell(pose.position.y());
        cell(planar_angle(pose));
        cell(scene.joint_coordinate(part));
    }
    csv_ += '\n';
}

}  // namespace cambrian
