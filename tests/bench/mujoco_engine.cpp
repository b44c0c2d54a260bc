// MuJoCo 2.2: double precision, joint coordinates (so that joints have no gaps), soft contacts.
// Motors are velocity actuators with our gains; drag is an external force, constant during a step.

#include "bench/drag_law.h"
#include "bench/motor_law.h"
#include "bench/mujoco_model.h"
#include "core/assert.h"
#include "support/body_plans.h"

#include <cmath>
#include <utility>

namespace cambrian::bench {
namespace {

class MujocoEngine;
thread_local const MujocoEngine* driven_engine = nullptr;  // the engine that advances now

class MujocoEngine final : public BenchEngine {
public:
    MujocoEngine(const BodyPlan& plan, const Environment& environment,
                 const MujocoSettings& settings, WorkAudit audit)
        : plan_(plan),
          environment_(environment),
          settings_(settings),
          audit_(audit),
          model_(build_mujoco_model(plan, environment, settings)),
          data_(mj_makeData(model_.get())),
          targets_(plan.parts.size(), 0.0),
          previous_targets_(plan.parts.size(), 0.0) {
        for (std::size_t i = 0; i < plan.parts.size(); ++i) {
            const std::string name = mujoco_name(i);
            body_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, name.c_str()));
            const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
            coordinate_.push_back(model_->jnt_dofadr[joint]);
        }
        CAMBRIAN_ASSERT(
            !has_drag(environment) || settings.integrator != MujocoIntegrator::kRungeKutta4,
            "drag is applied between the halves of a one-stage step");
    }

    void set_target(std::size_t part, double target) override { targets_[part] = target; }

    void advance_tick() override {
        tick_start_ = data_->time;
        driven_engine = this;
        mjcb_control = &MujocoEngine::drive_motors;
        for (int step = 0; step < settings_.steps_per_tick; ++step) {
            if (audit_ == WorkAudit::kOn) before_.assign(data_->qvel, data_->qvel + model_->nv);
            advance_step();
            if (audit_ == WorkAudit::kOn) add_works();
        }
        mjcb_control = nullptr;  // building another model makes trial steps
        previous_targets_ = targets_;
    }

    void read_motion(std::vector<PartMotion>& parts) override {
        mj_kinematics(model_.get(), data_.get());
        mj_comPos(model_.get(), data_.get());
        mj_comVel(model_.get(), data_.get());
        parts.clear();
        for (std::size_t i = 0; i < body_.size(); ++i)
            parts.push_back(motion_of(i));
    }

    double explained_work() const override { return work_; }

private:
    // MuJoCo asks for controls through one global callback, at every stage of a step.
    static void drive_motors(const mjModel*, mjData* data) {
        const MujocoEngine& engine = *driven_engine;
        const double share = (data->time - engine.tick_start_) / kTestTick;
        for (std::size_t i = 1; i < engine.plan_.parts.size(); ++i) {
            const MotorMode mode = engine.plan_.parts[i].motor_mode;
            data->ctrl[i - 1] =
                mode == MotorMode::kTorque
                    ? std::lerp(engine.previous_targets_[i], engine.targets_[i], share)
                    : wanted_rate(mode, engine.targets_[i], data->qpos[engine.coordinate_[i]]);
        }
    }

    void advance_step() {
        if (!has_drag(environment_)) {
            mj_step(model_.get(), data_.get());
            return;
        }
        mj_step1(model_.get(), data_.get());
        apply_drag();
        mj_step2(model_.get(), data_.get());
    }

    PartMotion motion_of(std::size_t part) const {
        const auto body = static_cast<std::size_t>(body_[part]);
        const mjtNum* position = data_->xpos + 3 * body;
        const mjtNum* orientation = data_->xquat + 4 * body;
        // Velocities are those of the point of the body at the centre of mass of its tree.
        const auto root = static_cast<std::size_t>(model_->body_rootid[body]);
        const mjtNum* velocity = data_->cvel + 6 * body;
        const mjtNum* reference = data_->subtree_com + 3 * root;
        const double spin = -velocity[1];
        return {position[0],
                position[2],
                2 * std::atan2(-orientation[2], orientation[0]),
                velocity[3] - spin * (position[2] - reference[2]),
                velocity[5] + spin * (position[0] - reference[0]),
                spin};
    }

    void apply_drag() {
        for (std::size_t i = 0; i < body_.size(); ++i) {
            const PlanarWrench drag =
                drag_on(motion_of(i), plan_.parts[i].half_extents, environment_);
            mjtNum* applied = data_->xfrc_applied + 6 * static_cast<std::size_t>(body_[i]);
            applied[0] = drag.force_x;
            applied[2] = drag.force_y;
            applied[4] = -drag.torque;
        }
    }

    // Sums the work of all generalized forces except gravity and inertial forces, which are in
    // qfrc_bias.
    void add_works() {
        for (std::size_t j = 0; j < before_.size(); ++j) {
            const double force =
                data_->qfrc_smooth[j] + data_->qfrc_bias[j] + data_->qfrc_constraint[j];
            work_ += model_->opt.timestep * force * 0.5 * (before_[j] + data_->qvel[j]);
        }
    }

    BodyPlan plan_;
    Environment environment_;
    MujocoSettings settings_;
    WorkAudit audit_;
    MujocoModel model_;
    MujocoData data_;
    std::vector<int> body_;        // MuJoCo's body of each part
    std::vector<int> coordinate_;  // index of its angle in qpos and qvel
    std::vector<double> targets_, previous_targets_;
    std::vector<double> before_;  // qvel before the step
    double tick_start_ = 0.0;     // s
    double work_ = 0.0;           // J
};

}  // namespace

EngineKind mujoco_engine(std::string id, const MujocoSettings& settings) {
    EngineKind kind;
    kind.id = std::move(id);
    kind.label = "MuJoCo 2.2, " + std::to_string(60 * settings.steps_per_tick) + " Hz";
    kind.make = [settings](const BodyPlan& plan, const Environment& environment, WorkAudit audit) {
        return std::make_unique<MujocoEngine>(plan, environment, settings, audit);
    };
    return kind;
}

}  // namespace cambrian::bench
