#include "spatial/spatial_scene.h"

#include "core/assert.h"
#include "spatial/audit.h"
#include "spatial/ground_contacts.h"
#include "spatial/joints.h"
#include "spatial/scene_motion.h"
#include "spatial/self_contacts.h"
#include "world/scene_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace cambrian::spatial {
namespace {

struct SavedSpatialState : SceneState {
    State state;
    Environment environment;
    bool motors_off = false;
};

// Nothing is kept between two ticks, so scenes in space have workspaces of their own.
class NoWorkspace final : public SceneWorkspace {};

Medium medium_of(const Environment& environment) {
    const SineCosine turn = sine_cosine(environment.gravity_direction * (kPi / 180.0));
    return {Vec3(environment.gravity * turn.cosine, environment.gravity * turn.sine, 0.0),
            environment.viscosity_linear, environment.viscosity_quadratic};
}

// While motors are off, nothing rubs.
Ground ground_of(const Environment& environment, bool motors_off) {
    return {environment.has_ground, motors_off ? 0.0 : environment.friction,
            environment.elasticity};
}

// It has as many functions as the interface of scenes; each is a few lines over the body it holds.
class SpatialScene final : public PhysicsScene {
public:
    SpatialScene(const Model& model, const Environment& environment, const SceneSettings& settings,
                 const Integrator& integrator)
        : settings_(settings),
          integrator_(&integrator),
          model_(model),
          control_(model, integrator, settings) {
        state_.motion = rest_motion(model_);
        state_.drive.frequency = settings.motor_frequency;
        state_.drive.speed_limit = settings.motor_speed_limit;
        use_environment(environment);
        evaluate_here();
        start_audit(model_, forcing_.medium, state_);
    }

    std::size_t part_count() const override { return static_cast<std::size_t>(model_.part_count); }
    Pose part_pose(std::size_t part) const override;
    Vec3 part_center(std::size_t part) const override { return center() + arm_of(part); }
    Vec3 part_axis(std::size_t part) const override { return axes_of(part).axis[0]; }
    Twist part_twist(std::size_t part) const override;
    using BodyView::joint_coordinate;
    using BodyView::joint_effort;
    using BodyView::joint_rate;
    double joint_coordinate(const JointDegree& degree) const override;
    double joint_rate(const JointDegree& degree) const override;
    double joint_effort(const JointDegree& degree) const override {
        const int d = slot_of(degree);
        return d < 0 ? 0.0 : state_.evaluation->loads.effort[d];
    }
    double stretch(std::size_t /*part*/) const override { return 0.0; }
    double stretch_rate(std::size_t /*part*/) const override { return 0.0; }
    double stretch_effort(std::size_t /*part*/) const override { return 0.0; }
    Vec3 part_half_extents(std::size_t part) const override { return this->part(part).half; }
    bool face_touched(std::size_t part, Face face) const override {
        return ((state_.touched[index(part)] >> static_cast<unsigned>(face)) & 1U) != 0;
    }
    Vec3 part_specific_force(std::size_t part) const override {
        return state_.specific_force[index(part)].value;
    }
    double part_load(std::size_t part) const override {
        return model_.measured[index(part)] ? state_.load[part] : 0.0;
    }
    double mass() const override { return model_.mass; }
    Vec3 center_of_mass() const override { return center(); }
    Vec3 center_of_mass_velocity() const override { return drift(); }
    double kinetic_energy() const override {
        return spatial::kinetic_energy(model_, state_.motion, state_.evaluation->kinematics);
    }
    Bounds bounds() const override;
    double lowest_point() const override {
        return lowest_corner(model_, state_.motion, state_.evaluation->kinematics);
    }

    void list_joint_coordinates(std::span<const JointDegree> degrees,
                                std::span<double> coordinates) const override {
        CAMBRIAN_ASSERT(coordinates.size() == degrees.size(), "a place for each coordinate");
        for (std::size_t i = 0; i < degrees.size(); ++i)
            coordinates[i] = joint_coordinate(degrees[i]);
    }
    using PhysicsScene::set_target;
    using PhysicsScene::target;
    void set_target(const JointDegree& degree, double target) override;
    double target(const JointDegree& degree) const override {
        const int d = slot_of(degree);
        return d < 0 ? 0.0 : state_.drive.end[d];
    }
    double largest_target_change() const override { return largest_target_change_; }
    void set_stretch_target(std::size_t /*part*/, double /*target*/) override {}
    SceneStatus advance(double duration) override;
    SceneStatus status() const override { return state_.status; }
    double time() const override { return state_.time; }
    void set_environment(const Environment& environment) override;
    void set_fixed_boxes(std::span<const FixedBox> boxes) override {
        CAMBRIAN_ASSERT(boxes.empty(), "walls are planar");
    }
    void set_motors_off(bool off) override;
    void translate(const Vec3& offset) override;
    void pull(std::size_t part, const Vec3& point_in_part, const Vec3& force) override;
    SceneSize size() const override { return {model_.body_count, 1, model_.part_count}; }
    void mark() override { mark_ = save(); }
    void go_back() override {
        CAMBRIAN_ASSERT(mark_ != nullptr, "a marked moment");
        restore(*mark_);
    }
    std::unique_ptr<SceneState> save() const override;
    void restore(const SceneState& state) override;
    std::unique_ptr<SceneWorkspace> take_workspace() override {
        return std::make_unique<NoWorkspace>();
    }
    void give_workspace(std::unique_ptr<SceneWorkspace> /*workspace*/) override {}
    SceneMotion motion() const override {
        return scene_motion_of(model_, state_.motion, state_.drive.end);
    }
    bool begin_at(const SceneMotion& motion) override;
    double energy() const override {
        return mechanical_energy(model_, forcing_.medium, state_.motion,
                                 state_.evaluation->kinematics);
    }
    const SceneAudit& audit() const override { return state_.audit; }
    void restart_audit() override { start_audit(model_, forcing_.medium, state_); }
    void list_contacts(std::vector<SceneContact>& contacts) const override;
    void list_impacts(std::vector<SceneImpact>& impacts) const override;
    void add_to_digest(Hash64& digest) const override {
        spatial::add_to_digest(model_, state_.motion, digest);
    }

private:
    std::size_t index(std::size_t part) const {
        CAMBRIAN_ASSERT(part < part_count(), "part index in range");
        return part;
    }
    const Part& part(std::size_t part) const { return model_.parts[index(part)]; }
    Vec3 center() const { return coordinate_vector(state_.motion.position + model_.place()); }
    Vec3 drift() const { return coordinate_vector(state_.motion.speed + model_.place()); }
    Turn axes_of(std::size_t part) const {
        return state_.evaluation->kinematics.turn[this->part(part).body] * this->part(part).turn;
    }
    // From the centre of mass of all.
    Vec3 arm_of(std::size_t part) const {
        const Kinematics& k = state_.evaluation->kinematics;
        const int b = this->part(part).body;
        return k.place[b] + k.turn[b] * this->part(part).place;
    }
    // The degree of freedom, or -1 if the joint has none of that number.
    int slot_of(const JointDegree& degree) const {
        if (index(degree.part) == 0 || leads_[degree.part] < 0) return -1;
        const Body& body = model_.bodies[leads_[degree.part]];
        return degree.degree < body.degree_count ? body.first_degree + degree.degree : -1;
    }
    void use_environment(const Environment& environment);
    void evaluate_here();

    SceneSettings settings_;
    const Integrator* integrator_;
    Model model_;
    // The body whose joint a part has, or -1.
    std::array<int, kMostParts> leads_ = joints_of(model_);
    Environment environment_;
    Forcing forcing_;
    State state_;
    StepControl control_;
    bool motors_off_ = false;
    double largest_target_change_ = 0.0;
    std::unique_ptr<SceneState> mark_;

    static std::array<int, kMostParts> joints_of(const Model& model) {
        std::array<int, kMostParts> joints{};
        int next = 0;  // bodies are numbered by their first parts
        for (int p = 0; p < model.part_count; ++p) {
            const bool first = model.parts[p].body == next;
            joints[static_cast<std::size_t>(p)] = first ? next++ : -1;
        }
        return joints;
    }
};

Pose SpatialScene::part_pose(std::size_t part) const {
    return {part_center(part), rotation_of(axes_of(part))};
}

Twist SpatialScene::part_twist(std::size_t part) const {
    const Kinematics& k = state_.evaluation->kinematics;
    const int b = this->part(part).body;
    const Vec3 arm = k.turn[b] * this->part(part).place;
    return {k.velocity[b] + cross(k.spin[b], arm) + drift(), k.spin[b]};
}

Bounds SpatialScene::bounds() const {
    Bounds bounds{center(), center()};
    for (std::size_t p = 0; p < part_count(); ++p) {
        const Turn axes = axes_of(p);
        const Vec3& half = part(p).half;
        Vec3 reach = Vec3::Zero();
        for (int a = 0; a < 3; ++a)
            reach += half[a] * axes.axis[a].cwiseAbs();
        const Vec3 middle = part_center(p);
        bounds.low = p == 0 ? Vec3(middle - reach) : Vec3(bounds.low.cwiseMin(middle - reach));
        bounds.high = p == 0 ? Vec3(middle + reach) : Vec3(bounds.high.cwiseMax(middle + reach));
    }
    return bounds;
}

namespace {

double angle_of(const BallAngles& angles, int degree) {
    return degree == 0 ? angles.bend_z : degree == 1 ? angles.bend_y : angles.twist;
}

}  // namespace

double SpatialScene::joint_coordinate(const JointDegree& degree) const {
    const int d = slot_of(degree);
    if (d < 0) return 0.0;
    const int b = model_.degrees[d].body;
    if (!model_.bodies[b].is_ball) return state_.motion.position[d];
    return angle_of(ball_angles(ball_attitude(model_, state_.motion, b)), degree.degree);
}

double SpatialScene::joint_rate(const JointDegree& degree) const {
    const int d = slot_of(degree);
    if (d < 0) return 0.0;
    const int b = model_.degrees[d].body;
    if (!model_.bodies[b].is_ball) return state_.motion.speed[d];
    return angle_of(
        ball_rates(ball_attitude(model_, state_.motion, b), ball_spin(model_, state_.motion, b)),
        degree.degree);
}

void SpatialScene::set_target(const JointDegree& degree, double target) {
    const int d = slot_of(degree);
    if (d < 0) return;
    const Degree& joint = model_.degrees[d];
    double reached = std::isfinite(target) ? target : 0.0;
    if (joint.mode == MotorMode::kPosition)
        reached = std::min(std::max(reached, joint.low), joint.high);
    state_.drive.end[d] = reached;
}

SceneStatus SpatialScene::advance(double duration) {
    CAMBRIAN_ASSERT(duration > 0.0, "a tick takes time");
    if (state_.status != SceneStatus::kRunning) return state_.status;
    largest_target_change_ = 0.0;
    for (int d = 0; d < model_.degree_count; ++d)
        largest_target_change_ = std::max(largest_target_change_,
                                          std::fabs(state_.drive.end[d] - state_.drive.start[d]));
    control_.advance(model_, forcing_, duration, state_);
    if (forcing_.pull_count > 0) state_.is_current = false;
    forcing_.pull_count = 0;
    return state_.status;
}

void SpatialScene::use_environment(const Environment& environment) {
    const bool had_contact = std::exchange(environment_, environment).self_contact;
    if (environment.self_contact != had_contact) {
        let_parts_touch(model_, environment.self_contact);
        control_ = StepControl(model_, *integrator_, settings_);
    }
    if (environment.density != model_.density) {
        // The motion keeps its velocities, so its angular momentum scales as well.
        const double factor = environment.density / model_.density;
        double* momentum = state_.motion.speed + model_.attitude();
        for (int i = 0; i < 3; ++i)
            momentum[i] *= factor;
        change_density(model_, environment.density);
    }
    forcing_.medium = medium_of(environment);
    forcing_.ground = ground_of(environment, motors_off_);
    state_.is_current = false;
}

// Updates the evaluation for displays; time does not pass.
void SpatialScene::evaluate_here() {
    forcing_.drive = state_.drive;
    evaluate(model_, forcing_, state_.motion, 0.0, *state_.evaluation, state_.rate);
}

void SpatialScene::set_environment(const Environment& environment) {
    const double before = energy();
    use_environment(environment);
    evaluate_here();
    state_.energy_reference += energy() - before;
}

void SpatialScene::set_motors_off(bool off) {
    motors_off_ = off;
    state_.drive.frequency = off ? 0.0 : settings_.motor_frequency;
    forcing_.ground = ground_of(environment_, off);
    state_.is_current = false;
}

void SpatialScene::translate(const Vec3& offset) {
    const double before = energy();
    set_coordinate_vector(state_.motion.position + model_.place(), center() + offset);
    state_.energy_reference += energy() - before;
}

void SpatialScene::pull(std::size_t part, const Vec3& point_in_part, const Vec3& force) {
    if (forcing_.pull_count == kMostPulls) return;
    const Part& pulled = this->part(part);
    forcing_.pulls[forcing_.pull_count++] = {pulled.body,
                                             pulled.place + pulled.turn * point_in_part, force};
    state_.is_current = false;
}

std::unique_ptr<SceneState> SpatialScene::save() const {
    auto saved = std::make_unique<SavedSpatialState>();
    saved->state = state_;
    saved->environment = environment_;
    saved->motors_off = motors_off_;
    return saved;
}

void SpatialScene::restore(const SceneState& state) {
    const auto* saved = dynamic_cast<const SavedSpatialState*>(&state);
    CAMBRIAN_ASSERT(saved != nullptr, "a state saved by a scene in space");
    forcing_.pull_count = 0;
    const bool same = saved->environment == environment_ && saved->motors_off == motors_off_;
    state_ = saved->state;
    if (same) return;
    const Environment environment = environment_;
    use_environment(saved->environment);
    const double before = energy();
    use_environment(environment);
    set_motors_off(motors_off_);
    evaluate_here();
    state_.energy_reference += energy() - before;
}

bool SpatialScene::begin_at(const SceneMotion& motion) {
    const std::optional<Motion> read = motion_of(model_, motion);
    if (!read) return false;
    const Drive drive = state_.drive;
    state_ = {};
    state_.motion = *read;
    state_.drive.frequency = drive.frequency;
    state_.drive.speed_limit = drive.speed_limit;
    std::copy(motion.targets.begin(), motion.targets.end(), state_.drive.start);
    std::copy(motion.targets.begin(), motion.targets.end(), state_.drive.end);
    forcing_.pull_count = 0;
    evaluate_here();
    start_audit(model_, forcing_.medium, state_);
    return true;
}

void SpatialScene::list_contacts(std::vector<SceneContact>& contacts) const {
    contacts.clear();
    const Kinematics& k = state_.evaluation->kinematics;
    for (int c = 0; c < state_.held.count; ++c) {
        const HeldContacts::Item& held = state_.held.items[c];
        if (!(held.force.x() > 0.0)) continue;
        const int other = held.other_body;
        contacts.push_back({center() + k.place[held.body] + k.turn[held.body] * held.point,
                            other < 0 ? held.normal : k.turn[other] * held.normal, held.force.x()});
    }
}

void SpatialScene::list_impacts(std::vector<SceneImpact>& impacts) const {
    impacts.clear();
    for (int i = 0; i < state_.impact_count; ++i) {
        const NotedImpact& noted = state_.impacts[i];
        if (!(noted.impulse > 0.0)) continue;
        impacts.push_back({.point = noted.point / noted.impulse,
                           .part = noted.part,
                           .other_part = noted.other_part,
                           .impulse = noted.impulse,
                           .lost = noted.lost});
    }
}

Result<std::unique_ptr<PhysicsScene>> make_spatial_scene(const BodyPlan& plan,
                                                         const Environment& environment,
                                                         const SceneSettings& settings) {
    const auto known = integrators();
    const auto integrator = std::find_if(known.begin(), known.end(), [&](const Integrator& each) {
        return each.id == settings.integrator;
    });
    if (integrator == known.end()) {
        std::vector<std::string> ids;
        for (const Integrator& each : known)
            ids.push_back(each.id);
        return unknown_integrator(settings.integrator, ids);
    }
    if (Status status = check_surroundings(environment, settings); !status) return status.error();
    const Result<Model> model = build_model(plan, environment.density);
    if (!model) return model.error();
    return std::unique_ptr<PhysicsScene>(
        std::make_unique<SpatialScene>(*model, environment, settings, *integrator));
}

}  // namespace
}  // namespace cambrian::spatial

namespace cambrian {

SceneKind spatial_scene_kind() {
    SceneKind kind;
    kind.id = "spatial";
    kind.label = "Articulated bodies in space";
    kind.dimensions = 3;
    kind.joints = spatial_joints();
    for (const spatial::Integrator& integrator : spatial::integrators())
        kind.integrators.push_back({integrator.id, integrator.label});
    kind.accurate_integrator = "dormand-prince";
    kind.make = spatial::make_spatial_scene;
    return kind;
}

}  // namespace cambrian
