#pragma once

#include "planar/joints/builtin_joints.h"
#include "world/physics_scene.h"
#include "world/scene_kind.h"

#include <vector>

namespace cambrian {

// A scene without physics: tests set the positions of parts and joints; targets are stored.
class FakeScene final : public PhysicsScene {
public:
    explicit FakeScene(std::size_t parts)
        : coordinates(parts, 0.0),
          targets(parts, 0.0),
          touched(parts),
          poses(parts),
          twists(parts),
          rates(parts, 0.0),
          efforts(parts, 0.0),
          specific_forces(parts, Vec3::Zero()),
          loads(parts, 0.0),
          stretches(parts, 0.0),
          stretch_rates(parts, 0.0),
          stretch_efforts(parts, 0.0),
          stretch_targets(parts, 0.0),
          half_extents(parts, Vec3(0.2, 0.05, 0.0)) {}

    std::size_t part_count() const override { return coordinates.size(); }
    Pose part_pose(std::size_t part) const override { return poses[part]; }
    Vec3 part_center(std::size_t part) const override { return poses[part].position; }
    Vec3 part_axis(std::size_t part) const override {
        return poses[part].orientation * Vec3::UnitX();
    }
    Twist part_twist(std::size_t part) const override { return twists[part]; }
    using BodyView::joint_coordinate;
    using BodyView::joint_effort;
    using BodyView::joint_rate;
    double joint_coordinate(const JointDegree& degree) const override {
        return coordinates[degree.part];
    }
    double joint_rate(const JointDegree& degree) const override { return rates[degree.part]; }
    double joint_effort(const JointDegree& degree) const override { return efforts[degree.part]; }
    double stretch(std::size_t part) const override { return stretches[part]; }
    double stretch_rate(std::size_t part) const override { return stretch_rates[part]; }
    double stretch_effort(std::size_t part) const override { return stretch_efforts[part]; }
    Vec3 part_half_extents(std::size_t part) const override { return half_extents[part]; }
    bool face_touched(std::size_t part, Face face) const override {
        return touched[part][static_cast<std::size_t>(face)];
    }
    Vec3 part_specific_force(std::size_t part) const override { return specific_forces[part]; }
    double part_load(std::size_t part) const override { return loads[part]; }
    double mass() const override { return 1.0; }
    Vec3 center_of_mass() const override { return Vec3::Zero(); }
    Vec3 center_of_mass_velocity() const override { return Vec3::Zero(); }
    double kinetic_energy() const override { return 0.0; }
    Bounds bounds() const override { return {}; }
    double lowest_point() const override { return 0.0; }

    void list_joint_coordinates(std::span<const JointDegree> degrees,
                                std::span<double> into) const override {
        for (std::size_t i = 0; i < degrees.size(); ++i)
            into[i] = coordinates[degrees[i].part];
    }
    using PhysicsScene::set_target;
    using PhysicsScene::target;
    void set_target(const JointDegree& degree, double target) override {
        targets[degree.part] = target;
    }
    double target(const JointDegree& degree) const override { return targets[degree.part]; }
    double largest_target_change() const override { return 0.0; }
    void set_stretch_target(std::size_t part, double target) override {
        stretch_targets[part] = target;
    }
    SceneStatus advance(double) override { return SceneStatus::kRunning; }
    SceneStatus status() const override { return SceneStatus::kRunning; }
    double time() const override { return 0.0; }
    void set_fixed_boxes(std::span<const FixedBox>) override {}
    void set_environment(const Environment&) override {}
    void set_motors_off(bool) override {}
    void translate(const Vec3&) override {}
    void pull(std::size_t, const Vec3&, const Vec3&) override {}
    SceneSize size() const override { return {}; }
    void mark() override {}
    void go_back() override {}
    std::unique_ptr<SceneState> save() const override { return std::make_unique<SceneState>(); }
    void restore(const SceneState&) override {}
    std::unique_ptr<SceneWorkspace> take_workspace() override {
        return std::make_unique<SceneWorkspace>();
    }
    void give_workspace(std::unique_ptr<SceneWorkspace>) override {}
    SceneMotion motion() const override { return {}; }
    bool begin_at(const SceneMotion&) override { return true; }
    double energy() const override { return 0.0; }
    const SceneAudit& audit() const override { return audit_; }
    void restart_audit() override {}
    void list_contacts(std::vector<SceneContact>&) const override {}
    void list_impacts(std::vector<SceneImpact>&) const override {}
    void add_to_digest(Hash64&) const override {}

    std::vector<double> coordinates;
    std::vector<double> targets;
    std::vector<std::array<bool, kFaceCount>> touched;
    std::vector<Pose> poses;
    std::vector<Twist> twists;
    std::vector<double> rates;
    std::vector<double> efforts;
    std::vector<Vec3> specific_forces;
    std::vector<double> loads;
    std::vector<double> stretches, stretch_rates, stretch_efforts, stretch_targets;
    std::vector<Vec3> half_extents;

private:
    SceneAudit audit_;
};

inline SceneKind fake_scene_kind() {
    SceneKind kind;
    kind.id = "fake";
    kind.joints = builtin_joints();
    return kind;
}

}  // namespace cambrian
