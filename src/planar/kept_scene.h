#pragma once

// A scene in the plane as it is kept in memory and read (world/body_view.h). Its body is in a
// workspace, in a room of another one, or in memory of its own. Otherwise it is packed. A packed
// body is unpacked when something must be known of it, and keeps its bits.

#include "core/assert.h"
#include "planar/island/packed_body.h"
#include "planar/island/scene_body.h"
#include "planar/stepping/audit.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cambrian {

// It has as many functions as the interface of bodies; each is a few lines over the body it holds.
class KeptScene : public BodyScene {
public:
    // The model is rejected before, if physics cannot advance it.
    KeptScene(PlanarModel&& model, const SceneSettings& settings, const IntegratorKind& integrator);

    std::size_t part_count() const override { return static_cast<std::size_t>(size_.parts); }
    Pose part_pose(std::size_t part) const override;
    Vec3 part_center(std::size_t part) const override;
    Vec3 part_axis(std::size_t part) const override;
    Twist part_twist(std::size_t part) const override;
    double joint_coordinate(const JointDegree& degree) const override {
        return at_slot(joint_of(degree), body().state.cache().kinematics.joint_position);
    }
    double joint_rate(const JointDegree& degree) const override {
        return at_slot(joint_of(degree), body().state.cache().kinematics.joint_rate);
    }
    double joint_effort(const JointDegree& degree) const override {
        return at_slot(joint_of(degree), body().state.cache().motor_effort);
    }
    double stretch(std::size_t part) const override {
        return at_slot(stretch_of(part), body().state.cache().kinematics.joint_position);
    }
    double stretch_rate(std::size_t part) const override {
        return at_slot(stretch_of(part), body().state.cache().kinematics.joint_rate);
    }
    double stretch_effort(std::size_t part) const override {
        return at_slot(stretch_of(part), body().state.cache().motor_effort);
    }
    Vec3 part_half_extents(std::size_t part) const override;
    bool face_touched(std::size_t part, Face face) const override;
    Vec3 part_specific_force(std::size_t part) const override;
    double part_load(std::size_t part) const override;
    double mass() const override { return body().model.total_mass; }
    Vec3 center_of_mass() const override { return mean_of_trees(body().state.motion.position); }
    Vec3 center_of_mass_velocity() const override {
        return mean_of_trees(body().state.motion.speed);
    }
    double kinetic_energy() const override {
        return cambrian::kinetic_energy(body().model, body().state.cache().kinematics);
    }
    Bounds bounds() const override;
    double lowest_point() const override;
    double ground_gap() const override;

    void list_joint_coordinates(std::span<const JointDegree> degrees,
                                std::span<double> coordinates) const override;
    double target(const JointDegree& degree) const override {
        return at_slot(joint_of(degree), body().state.drive_end);
    }
    double largest_target_change() const override;
    SceneSize size() const override { return size_; }
    SceneStatus status() const override { return body().state.status; }
    double time() const override { return body().state.time; }
    void mark() override;
    void go_back() override;
    SceneBody& open(SceneBody& room) override;
    void close() override;
    std::unique_ptr<SceneWorkspace> take_workspace() override;
    void give_workspace(std::unique_ptr<SceneWorkspace> workspace) override;
    SceneMotion motion() const override;
    double energy() const override {
        return mechanical_energy(body().model, body().forcing.medium, body().state.motion,
                                 kinetic_energy());
    }
    const SceneAudit& audit() const override { return body().state.audit; }
    void list_contacts(std::vector<SceneContact>& contacts) const override;
    void list_impacts(std::vector<SceneImpact>& impacts) const override;
    void add_to_digest(Hash64& digest) const override;

protected:
    // The body with the joint of this part, or -1 if the part is a root or has a rigid joint.
    int joint_of(const JointDegree& degree) const {
        return degree.degree == 0 ? body().model.part_joint[checked(degree.part)] : -1;
    }
    std::size_t checked(std::size_t part) const {
        CAMBRIAN_ASSERT(part < part_count(), "part index in range");
        return part;
    }
    int stretch_of(std::size_t part) const { return body().model.stretch_slot[body_of(part)]; }
    static double at_slot(int slot, const PerBody& numbers) {
        return slot < 0 ? 0.0 : numbers[slot];
    }
    int body_of(std::size_t part) const { return body().model.part_body[checked(part)]; }
    // The body. If it is packed, it gets memory of its own, since something must be known of it.
    SceneBody& body() const {
        if (body_ == nullptr) [[unlikely]]
            unpack_alone();
        return *body_;
    }
    bool is_packed() const { return body_ == nullptr; }
    PackedBody& packed() { return packed_; }
    StepControl& control() { return workspace_->control; }
    // Updates the cache for displays; time does not pass.
    void evaluate_here() const;

private:
    // The moment to which go_back() goes, and the forces during the next tick.
    struct Mark {
        PackedNumbers moment;
        std::vector<HeldForce> pulls;
    };

    Vec3 mean_of_trees(const PerCoordinate& coordinates) const;
    // World offset of a part's centre from its body's centre of mass.
    Vec2 arm_of(std::size_t part) const;
    // Not marked cold: with it, gcc would move loops that run every tick into the section of cold
    // code.
    [[gnu::noinline]] void unpack_alone() const;
    void unpack_into(SceneBody& room) const;
    void pack() const;

    SceneSize size_;
    std::unique_ptr<StepWorkspace> workspace_;
    std::unique_ptr<Mark> mark_;
    mutable SceneBody* body_ = nullptr;
    mutable std::unique_ptr<SceneBody> own_;
    mutable PackedBody packed_;
    mutable bool is_stale_ = false;  // whether its cache is not that of its packed motion
};

}  // namespace cambrian
