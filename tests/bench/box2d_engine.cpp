// Box2D 2.4.1: single precision, maximal coordinates, sequential impulses. Its motors are its own
// joint motors with a new speed every step, or torques. Drag and torques are external forces,
// constant during a step.

#include "bench/drag_law.h"
#include "bench/engine_kinds.h"
#include "bench/motor_law.h"
#include "bench/pair_filter.h"
#include "core/assert.h"
#include "math/angle.h"
#include "planar/model_building.h"
#include "support/body_plans.h"

#include <algorithm>
#include <box2d/box2d.h>
#include <cmath>
#include <cstdint>
#include <utility>

namespace cambrian::bench {
namespace {

constexpr double kRestingSpeed = 0.3;  // m/s; collisions bounce above it, as in our physics

float narrow(double value) {
    return static_cast<float>(value);
}
b2Vec2 narrow(const Vec3& vector) {
    return {narrow(vector.x()), narrow(vector.y())};
}
double mean_of(double before, double after) {
    return 0.5 * (before + after);
}

class PartContactFilter final : public b2ContactFilter {
public:
    explicit PartContactFilter(const BodyPlan& plan) : pairs_(plan), ground_(plan.parts.size()) {}

    bool ShouldCollide(b2Fixture* a, b2Fixture* b) override {
        const std::uintptr_t first = a->GetUserData().pointer;
        const std::uintptr_t second = b->GetUserData().pointer;
        if (first == ground_ || second == ground_) return true;
        return pairs_.may_touch(first, second);
    }

private:
    PairFilter pairs_;
    std::uintptr_t ground_;
};

// Returns the inertia, in kg m^2, against which an effort at each part's joint acts; 0 for the
// root.
std::vector<double> joint_inertias(const BodyPlan& plan, double density) {
    const Result<PlanarModel> model = build_planar_model(plan, density);
    CAMBRIAN_ASSERT(model.has_value(), "benchmark bodies are valid");
    std::vector<double> inertias(plan.parts.size(), 0.0);
    for (std::size_t i = 1; i < inertias.size(); ++i)
        inertias[i] = model->effective_inertia[model->part_body[i]];
    return inertias;
}

class Box2dEngine final : public BenchEngine {
public:
    Box2dEngine(const BodyPlan& plan, const Environment& environment, const Box2dSettings& settings,
                WorkAudit audit)
        : plan_(plan),
          environment_(environment),
          settings_(settings),
          audit_(audit),
          step_(kTestTick / settings.steps_per_tick),
          filter_(plan),
          world_(gravity(environment)),
          targets_(plan.parts.size(), 0.0),
          previous_targets_(plan.parts.size(), 0.0),
          inertia_(settings.motors == Box2dMotors::kTorques
                       ? joint_inertias(plan, environment.density)
                       : std::vector<double>()),
          torque_(plan.parts.size(), 0.0),
          drag_(plan.parts.size()) {
        world_.SetAllowSleeping(false);
        world_.SetContactFilter(&filter_);
        for (std::size_t i = 0; i < plan.parts.size(); ++i)
            add_body(i);
        for (std::size_t i = 1; i < plan.parts.size(); ++i)
            add_joint(i);
        if (environment.has_ground) add_ground();
    }

    void set_target(std::size_t part, double target) override { targets_[part] = target; }

    void advance_tick() override {
        for (int step = 0; step < settings_.steps_per_tick; ++step) {
            drive_motors((step + 0.5) / settings_.steps_per_tick);
            if (has_drag(environment_)) apply_drag();
            if (audit_ == WorkAudit::kOn) read_motion(before_);
            world_.Step(narrow(step_), settings_.velocity_iterations,
                        settings_.position_iterations);
            if (audit_ == WorkAudit::kOn) add_works();
        }
        previous_targets_ = targets_;
    }

    void read_motion(std::vector<PartMotion>& parts) override {
        parts.clear();
        for (const b2Body* body : bodies_)
            parts.push_back(motion_of(*body));
    }

    double explained_work() const override { return work_; }

private:
    static b2Vec2 gravity(const Environment& environment) {
        const double angle = to_radians(environment.gravity_direction);
        return {narrow(environment.gravity * std::cos(angle)),
                narrow(environment.gravity * std::sin(angle))};
    }

    static PartMotion motion_of(const b2Body& body) {
        const b2Vec2 position = body.GetPosition();
        const b2Vec2 velocity = body.GetLinearVelocity();
        return {
            static_cast<double>(position.x),      static_cast<double>(position.y),
            static_cast<double>(body.GetAngle()), static_cast<double>(velocity.x),
            static_cast<double>(velocity.y),      static_cast<double>(body.GetAngularVelocity())};
    }

    b2FixtureDef surface(std::size_t owner) const {
        b2FixtureDef fixture;
        fixture.density = narrow(environment_.density);
        fixture.friction = narrow(environment_.friction);
        fixture.restitution = narrow(environment_.elasticity);
        fixture.restitutionThreshold = narrow(kRestingSpeed);
        fixture.userData.pointer = owner;
        return fixture;
    }

    void add_body(std::size_t index) {
        const PlannedPart& part = plan_.parts[index];
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position = narrow(part.rest_pose.position);
        definition.angle = narrow(part.rest_angle);
        definition.allowSleep = false;
        b2Body* body = world_.CreateBody(&definition);
        b2PolygonShape box;
        box.SetAsBox(narrow(part.half_extents.x()), narrow(part.half_extents.y()));
        b2FixtureDef fixture = surface(index);
        fixture.shape = &box;
        body->CreateFixture(&fixture);
        bodies_.push_back(body);
    }

    void add_joint(std::size_t index) {
        const PlannedPart& part = plan_.parts[index];
        const auto parent = static_cast<std::size_t>(part.parent);
        b2RevoluteJointDef definition;
        definition.bodyA = bodies_[parent];
        definition.bodyB = bodies_[index];
        definition.localAnchorA = narrow(part.anchor_in_parent);
        definition.localAnchorB = narrow(part.anchor_in_child);
        definition.referenceAngle = narrow(part.rest_angle - plan_.parts[parent].rest_angle);
        definition.enableLimit = true;
        definition.lowerAngle = narrow(part.limit_low);
        definition.upperAngle = narrow(part.limit_high);
        definition.enableMotor = has_joint_motor(part);
        definition.maxMotorTorque = narrow(part.max_effort);
        joints_.push_back(static_cast<b2RevoluteJoint*>(world_.CreateJoint(&definition)));
    }

    void add_ground() {
        constexpr float reach = 1000.0F;  // m
        const b2BodyDef definition;
        b2EdgeShape edge;
        edge.SetTwoSided({-reach, 0.0F}, {reach, 0.0F});
        b2FixtureDef fixture = surface(plan_.parts.size());
        fixture.shape = &edge;
        world_.CreateBody(&definition)->CreateFixture(&fixture);
    }

    bool has_joint_motor(const PlannedPart& part) const {
        return settings_.motors == Box2dMotors::kJointMotors &&
               part.motor_mode != MotorMode::kTorque;
    }

    void drive_motors(double tick_share) {
        for (std::size_t i = 1; i < bodies_.size(); ++i) {
            const PlannedPart& part = plan_.parts[i];
            b2RevoluteJoint& joint = *joints_[i - 1];
            if (!has_joint_motor(part)) {
                torque_[i] = torque_of(i, tick_share);
                twist(joint, torque_[i]);
                continue;
            }
            const auto angle = static_cast<double>(joint.GetJointAngle());
            joint.SetMotorSpeed(narrow(wanted_rate(part.motor_mode, targets_[i], angle)));
        }
    }

    double torque_of(std::size_t index, double tick_share) const {
        const PlannedPart& part = plan_.parts[index];
        const b2RevoluteJoint& joint = *joints_[index - 1];
        const double target = targets_[index];
        if (part.motor_mode == MotorMode::kTorque)
            return part.max_effort * std::lerp(previous_targets_[index], target, tick_share);
        const auto angle = static_cast<double>(joint.GetJointAngle());
        const auto rate = static_cast<double>(joint.GetJointSpeed());
        return motor_torque(part, inertia_[index], wanted_rate(part.motor_mode, target, angle),
                            rate);
    }

    static void twist(b2RevoluteJoint& joint, double torque) {
        joint.GetBodyB()->ApplyTorque(narrow(torque), true);
        joint.GetBodyA()->ApplyTorque(narrow(-torque), true);
    }

    void apply_drag() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            drag_[i] = drag_on(motion_of(*bodies_[i]), plan_.parts[i].half_extents, environment_);
            bodies_[i]->ApplyForceToCenter({narrow(drag_[i].force_x), narrow(drag_[i].force_y)},
                                           true);
            bodies_[i]->ApplyTorque(narrow(drag_[i].torque), true);
        }
    }

    // With the mean of the velocities before and after, the work of forces and impulses is exact.
    // Contacts are left out, since the engine does not report their impulses with velocities.
    void add_works() {
        read_motion(after_);
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const PartMotion& a = before_[i];
            const PartMotion& b = after_[i];
            work_ += step_ * (drag_[i].force_x * mean_of(a.velocity_x, b.velocity_x) +
                              drag_[i].force_y * mean_of(a.velocity_y, b.velocity_y) +
                              drag_[i].torque * mean_of(a.spin, b.spin));
        }
        for (std::size_t i = 1; i < bodies_.size(); ++i) {
            const auto parent = static_cast<std::size_t>(plan_.parts[i].parent);
            const double before = before_[i].spin - before_[parent].spin;
            const double after = after_[i].spin - after_[parent].spin;
            const auto reaction =
                static_cast<double>(joints_[i - 1]->GetReactionTorque(narrow(1.0 / step_)));
            work_ += step_ * (reaction + torque_[i]) * mean_of(before, after);
        }
    }

    BodyPlan plan_;
    Environment environment_;
    Box2dSettings settings_;
    WorkAudit audit_;
    double step_;  // s
    PartContactFilter filter_;
    b2World world_;
    std::vector<b2Body*> bodies_;
    std::vector<b2RevoluteJoint*> joints_;  // joint of part i at i - 1
    std::vector<double> targets_, previous_targets_;
    std::vector<double> inertia_;  // kg m^2, at each part's joint; empty if Box2D's motors drive it
    std::vector<double> torque_;   // N m, external torque during this step
    std::vector<PlanarWrench> drag_;
    std::vector<PartMotion> before_, after_;
    double work_ = 0.0;  // J
};

}  // namespace

EngineKind box2d_engine(std::string id, const Box2dSettings& settings) {
    EngineKind kind;
    kind.id = std::move(id);
    kind.label = "Box2D 2.4.1, " + std::to_string(60 * settings.steps_per_tick) + " Hz, " +
                 std::to_string(settings.velocity_iterations) + "/" +
                 std::to_string(settings.position_iterations) + " iterations" +
                 (settings.motors == Box2dMotors::kTorques ? ", torques" : "");
    kind.audits_contacts = false;
    kind.make = [settings](const BodyPlan& plan, const Environment& environment, WorkAudit audit) {
        return std::make_unique<Box2dEngine>(plan, environment, settings, audit);
    };
    return kind;
}

}  // namespace cambrian::bench
