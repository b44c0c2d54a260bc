// Our own physics. The energy audit is part of every trial, so it is always on.

#include "bench/engine_kinds.h"
#include "bench/planar_runs.h"
#include "support/body_plans.h"

#include <utility>

namespace cambrian::bench {
namespace {

class PlanarEngine final : public BenchEngine {
public:
    explicit PlanarEngine(std::unique_ptr<PhysicsScene> scene) : scene_(std::move(scene)) {}

    void set_target(std::size_t part, double target) override { scene_->set_target(part, target); }
    void advance_tick() override { scene_->advance(kTestTick); }

    void read_motion(std::vector<PartMotion>& parts) override {
        parts.clear();
        for (std::size_t i = 0; i < scene_->part_count(); ++i) {
            const Pose pose = scene_->part_pose(i);
            const Twist twist = scene_->part_twist(i);
            parts.push_back({pose.position.x(), pose.position.y(), planar_angle(pose),
                             twist.linear.x(), twist.linear.y(), twist.angular.z()});
        }
    }

    double explained_work() const override {
        const SceneAudit& audit = scene_->audit();
        return audit.motor_work + audit.drag_work + audit.contact_work + audit.limit_work +
               audit.impulse_work;
    }

private:
    std::unique_ptr<PhysicsScene> scene_;
};

}  // namespace

EngineKind planar_engine(std::string id, const SceneSettings& settings) {
    EngineKind kind;
    kind.id = std::move(id);
    kind.label = "Cambrian, " + settings.integrator;
    kind.make = [settings](const BodyPlan& plan, const Environment& environment, WorkAudit) {
        return std::make_unique<PlanarEngine>(make_planar_scene(plan, environment, settings));
    };
    return kind;
}

}  // namespace cambrian::bench
