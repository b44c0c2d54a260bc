#include "core/assert.h"
#include "core/text/nearest_name.h"
#include "math/angle.h"
#include "planar/contact/terrain_contacts.h"
#include "planar/integrators/builtin_integrators.h"
#include "planar/island/packed_body.h"
#include "planar/island/scene_body.h"
#include "planar/model/stretching.h"
#include "planar/model_building.h"
#include "planar/scene_copies.h"
#include "planar/stepping/audit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cambrian {
namespace {

struct SavedState : SceneState {
    SavedState(const SimulationState& saved, const Environment& surroundings, bool off)
        : state(saved), environment(surroundings), motors_off(off) {}
    SimulationState state;
    Environment environment;
    bool motors_off;
};

Medium medium_of(const Environment& environment) {
    const SineCosine turn = sine_cosine_of_degrees(environment.gravity_direction);
    return {environment.gravity * turn.cosine, environment.gravity * turn.sine,
            environment.viscosity_linear, environment.viscosity_quadratic};
}

// The four corners of a part in its body's frame, m.
struct Corners {
    Simd4d x, y;
};

CAMBRIAN_INLINE Corners corners_of(const PlanarModel& model, const Kinematics& k, int part) {
    Corners corners = {load_lanes(model.corner_x + 4 * part),
                       load_lanes(model.corner_y + 4 * part)};
    if (k.deforms) {
        const int b = model.part_body[part];
        corners.x *= k.length_growth[b];
        corners.y *= k.width_growth[b];
    }
    return corners;
}

CAMBRIAN_INLINE Simd4d heights_of(const Corners& corners, const Kinematics& k, int body) {
    return k.y[body] + (k.sine[body] * corners.x + k.cosine[body] * corners.y);
}

// The moment to which go_back() goes, and the forces during the next tick.
struct Mark {
    PackedNumbers moment;
    std::vector<HeldForce> pulls;
};

// An environment with the ground that its settings describe.
struct ShapedWorld {
    const Environment& environment;
    std::shared_ptr<const Terrain> terrain;
};

// It has as many functions as the interface of scenes; each is a few lines over the body it holds.
class PlanarScene final : public BodyScene {
public:
    PlanarScene(PlanarModel&& model, const ShapedWorld& world, const SceneSettings& settings,
                const IntegratorKind& integrator)
        : motor_frequency_(settings.motor_frequency),
          size_{model.body_count, model.tree_count, model.part_count},
          environment_(world.environment),
          terrain_(world.terrain),
          workspace_(std::make_unique<StepWorkspace>(integrator, settings)),
          body_(&workspace_->room(0)) {
        body_->model = std::move(model);
        workspace_->control.change_model(body_->model);
        body().forcing.drive.frequency = motor_frequency_;
        body().forcing.drive.speed_limit = settings.motor_speed_limit;
        body().state.motion = rest_motion(body().model);
        use_environment(world.environment);
        evaluate_here();
        start_audit(body().model, body().forcing.medium, body().state);
    }

    std::size_t part_count() const override { return static_cast<std::size_t>(size_.parts); }
    Pose part_pose(std::size_t part) const override;
    Vec3 part_center(std::size_t part) const override;
    Vec3 part_axis(std::size_t part) const override;
    Twist part_twist(std::size_t part) const override;
    double joint_coordinate(const JointDegree& degree) const override;
    double joint_rate(const JointDegree& degree) const override;
    double joint_effort(const JointDegree& degree) const override;
    double stretch(std::size_t part) const override;
    double stretch_rate(std::size_t part) const override;
    double stretch_effort(std::size_t part) const override;
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
    void set_target(const JointDegree& degree, double target) override;
    double target(const JointDegree& degree) const override;
    double largest_target_change() const override;
    void set_stretch_target(std::size_t part, double target) override;
    SceneStatus advance(double duration) override;
    SceneStatus status() const override { return body().state.status; }
    double time() const override { return body().state.time; }
    void set_environment(const Environment& environment) override;
    void set_fixed_boxes(std::span<const FixedBox> boxes) override;
    void set_motors_off(bool off) override;
    void translate(const Vec3& offset) override;
    void pull(std::size_t part, const Vec3& point_in_part, const Vec3& force) override;
    SceneSize size() const override { return size_; }
    void mark() override;
    void go_back() override;
    SceneBody& open(SceneBody& room) override;
    void close() override;
    std::unique_ptr<SceneState> save() const override {
        return std::make_unique<SavedState>(body().state, environment_, body().motors_off);
    }
    void restore(const SceneState& state) override;
    std::unique_ptr<SceneWorkspace> take_workspace() override;
    void give_workspace(std::unique_ptr<SceneWorkspace> workspace) override;
    SceneMotion motion() const override;
    bool begin_at(const SceneMotion& motion) override;
    double energy() const override {
        return mechanical_energy(body().model, body().forcing.medium, body().state.motion,
                                 kinetic_energy());
    }
    const SceneAudit& audit() const override { return body().state.audit; }
    void restart_audit() override {
        start_audit(body().model, body().forcing.medium, body().state);
    }
    void list_contacts(std::vector<SceneContact>& contacts) const override;
    void list_impacts(std::vector<SceneImpact>& impacts) const override;
    void add_to_digest(Hash64& digest) const override;

private:
    Vec3 mean_of_trees(const PerCoordinate& coordinates) const;
    // The body with the joint of this part, or -1 if the part is a root or has a rigid joint.
    int joint_of(const JointDegree& degree) const {
        return degree.degree == 0 ? body().model.part_joint[checked(degree.part)] : -1;
    }
    std::size_t checked(std::size_t part) const {
        CAMBRIAN_ASSERT(part < part_count(), "part index in range");
        return part;
    }
    int stretch_of(std::size_t part) const { return body().model.stretch_slot[body_of(part)]; }
    void set_slot_target(int slot, double target);
    int body_of(std::size_t part) const { return body().model.part_body[checked(part)]; }
    // World offset of a point of a part from its body's centre of mass.
    Vec2 arm_of(std::size_t part, double x, double y) const;
    void use_environment(const Environment& environment);
    double energy_under(const Environment& environment) const;
    void evaluate_here() const;
    // The body. If it is packed, it gets memory of its own, since something must be known of it.
    SceneBody& body() const {
        if (body_ == nullptr) [[unlikely]]
            unpack_alone();
        return *body_;
    }
    // Not marked cold: with it, gcc would move loops that run every tick into the section of cold
    // code.
    [[gnu::noinline]] void unpack_alone() const;
    void unpack_into(SceneBody& room) const;
    void pack() const;

    double motor_frequency_;
    SceneSize size_;
    Environment environment_;
    std::shared_ptr<const Terrain> terrain_;  // of the environment; null if the ground is flat
    std::unique_ptr<StepWorkspace> workspace_;
    std::unique_ptr<Mark> mark_;
    // The body is in the workspace, in a room of another one, or in memory of its own. Otherwise it
    // is packed. A packed body is unpacked when something must be known of it, and keeps its bits.
    mutable SceneBody* body_ = nullptr;
    mutable std::unique_ptr<SceneBody> own_;
    mutable PackedBody packed_;
    mutable bool is_stale_ = false;  // whether its cache is not that of its packed motion
};

void PlanarScene::pack() const {
    packed_.pack(*body_);
    body_ = nullptr;
    own_.reset();
}

void PlanarScene::unpack_into(SceneBody& room) const {
    packed_.unpack(room);
    body_ = &room;
    if (!std::exchange(is_stale_, false)) return;
    evaluate_here();
    body_->state.cache_is_current = false;
}

void PlanarScene::unpack_alone() const {
    own_ = std::make_unique<SceneBody>();
    unpack_into(*own_);
}

SceneBody& PlanarScene::open(SceneBody& room) {
    if (body_ == nullptr) unpack_into(room);
    return *body_;
}

void PlanarScene::close() {
    if (!workspace_) pack();
}

Vec2 PlanarScene::arm_of(std::size_t part, double x, double y) const {
    const PlanarModel& model = body().model;
    const int b = body_of(part);
    const Kinematics& k = body().state.cache().kinematics;
    const double body_x =
        model.part_x[part] + model.part_cosine[part] * x - model.part_sine[part] * y;
    const double body_y =
        model.part_y[part] + model.part_sine[part] * x + model.part_cosine[part] * y;
    const Simd2d arm = material_arm(k, b, body_x, body_y);
    return {arm[0], arm[1]};
}

Vec3 PlanarScene::mean_of_trees(const PerCoordinate& coordinates) const {
    const PlanarModel& model = body().model;
    Vec3 mean = Vec3::Zero();
    for (int t = 0; t < model.tree_count; ++t) {
        const int center = center_of(model, t);
        const double share = model.tree_mass[t] / model.total_mass;
        mean += share * Vec3(coordinates[center], coordinates[center + 1], 0.0);
    }
    return mean;
}

Pose PlanarScene::part_pose(std::size_t part) const {
    const Vec3 center = part_center(part);
    const double angle =
        body().state.cache().kinematics.angle[body_of(part)] + body().model.part_angle[part];
    return planar_pose(center.x(), center.y(), angle);
}

Vec3 PlanarScene::part_center(std::size_t part) const {
    const int b = body_of(part);
    const Kinematics& k = body().state.cache().kinematics;
    const Vec2 arm = arm_of(part, 0.0, 0.0);
    return {k.x[b] + arm.x(), k.y[b] + arm.y(), 0.0};
}

Vec3 PlanarScene::part_axis(std::size_t part) const {
    const int b = body_of(part);
    const Kinematics& k = body().state.cache().kinematics;
    const double cosine = body().model.part_cosine[part];
    const double sine = body().model.part_sine[part];
    return {k.cosine[b] * cosine - k.sine[b] * sine, k.sine[b] * cosine + k.cosine[b] * sine, 0.0};
}

Twist PlanarScene::part_twist(std::size_t part) const {
    const int b = body_of(part);
    const Kinematics& k = body().state.cache().kinematics;
    const Vec2 arm = arm_of(part, 0.0, 0.0);
    return {Vec3(k.velocity_x[b] - k.spin[b] * arm.y(), k.velocity_y[b] + k.spin[b] * arm.x(), 0.0),
            Vec3(0.0, 0.0, k.spin[b])};
}

double PlanarScene::joint_coordinate(const JointDegree& degree) const {
    const int joint = joint_of(degree);
    return joint < 0 ? 0.0 : body().state.cache().kinematics.joint_position[joint];
}

void PlanarScene::list_joint_coordinates(std::span<const JointDegree> degrees,
                                         std::span<double> coordinates) const {
    CAMBRIAN_ASSERT(coordinates.size() == degrees.size(), "a place for each coordinate");
    const PerBody& positions = body().state.cache().kinematics.joint_position;
    double* coordinate = coordinates.data();
    for (const JointDegree& degree : degrees) {
        const int joint = joint_of(degree);
        *coordinate++ = joint < 0 ? 0.0 : positions[joint];
    }
}

double PlanarScene::joint_rate(const JointDegree& degree) const {
    const int joint = joint_of(degree);
    if (joint < 0) return 0.0;
    return body().state.cache().kinematics.joint_rate[joint];
}

double PlanarScene::joint_effort(const JointDegree& degree) const {
    const int joint = joint_of(degree);
    return joint < 0 ? 0.0 : body().state.cache().motor_effort[joint];
}

double PlanarScene::stretch(std::size_t part) const {
    const int slot = stretch_of(part);
    return slot < 0 ? 0.0 : body().state.cache().kinematics.joint_position[slot];
}

double PlanarScene::stretch_rate(std::size_t part) const {
    const int slot = stretch_of(part);
    return slot < 0 ? 0.0 : body().state.cache().kinematics.joint_rate[slot];
}

double PlanarScene::stretch_effort(std::size_t part) const {
    const int slot = stretch_of(part);
    return slot < 0 ? 0.0 : body().state.cache().motor_effort[slot];
}

Vec3 PlanarScene::part_half_extents(std::size_t part) const {
    const int b = body_of(part);
    Vec3 rest(body().model.half_length[part], body().model.half_width[part], 0.0);
    if (body().model.stretch_slot[b] < 0) return rest;
    const Kinematics& k = body().state.cache().kinematics;
    return {k.length_growth[b] * rest.x(), k.width_growth[b] * rest.y(), 0.0};
}

bool PlanarScene::face_touched(std::size_t part, Face face) const {
    CAMBRIAN_ASSERT(part < part_count(), "part index in range");
    return ((body().state.touched[part] >> static_cast<unsigned>(face)) & 1U) != 0;
}

Vec3 PlanarScene::part_specific_force(std::size_t part) const {
    CAMBRIAN_ASSERT(part < part_count(), "part index in range");
    return {body().state.forces.specific_x[part], body().state.forces.specific_y[part], 0.0};
}

double PlanarScene::part_load(std::size_t part) const {
    CAMBRIAN_ASSERT(part < part_count(), "part index in range");
    return body().state.forces.load[part];
}

Bounds PlanarScene::bounds() const {
    const PlanarModel& model = body().model;
    const Kinematics& k = body().state.cache().kinematics;
    Simd4d low_x = all_lanes(std::numeric_limits<double>::infinity());
    Simd4d low_y = low_x;
    Simd4d high_x = -low_x;
    Simd4d high_y = -low_y;
    for (int part = 0; part < model.part_count; ++part) {
        const int b = model.part_body[part];
        const Corners corners = corners_of(model, k, part);
        const Simd4d x = k.x[b] + (k.cosine[b] * corners.x - k.sine[b] * corners.y);
        const Simd4d y = heights_of(corners, k, b);
        low_x = lesser(x, low_x);
        low_y = lesser(y, low_y);
        high_x = greater(x, high_x);
        high_y = greater(y, high_y);
    }
    return {Vec3(-largest_of(-low_x), -largest_of(-low_y), 0.0),
            Vec3(largest_of(high_x), largest_of(high_y), 0.0)};
}

double PlanarScene::lowest_point() const {
    const PlanarModel& model = body().model;
    const Kinematics& k = body().state.cache().kinematics;
    Simd4d low = all_lanes(std::numeric_limits<double>::infinity());
    for (int part = 0; part < model.part_count; ++part) {
        const Corners corners = corners_of(model, k, part);
        low = lesser(heights_of(corners, k, model.part_body[part]), low);
    }
    return -largest_of(-low);
}

double PlanarScene::ground_gap() const {
    if (!terrain_) return lowest_point();
    const Kinematics& k = body().state.cache().kinematics;
    PartPlaces places;
    place_parts(body().model, k, places);
    return height_above_terrain(body().model, places, *terrain_);
}

void PlanarScene::set_target(const JointDegree& degree, double target) {
    set_slot_target(joint_of(degree), target);
}

void PlanarScene::set_stretch_target(std::size_t part, double target) {
    set_slot_target(stretch_of(part), target);
}

void PlanarScene::set_slot_target(int slot, double target) {
    if (slot < 0) return;
    SceneBody& own = body();
    double reached = std::isfinite(target) ? target : 0.0;
    if (own.model.motor_mode[slot] == MotorMode::kPosition) {
        const double low = own.model.limit_low[slot];
        const double high = own.model.limit_high[slot];
        reached = std::min(std::max(reached, low), high);
    }
    own.state.drive_end[slot] = reached;
}

double PlanarScene::target(const JointDegree& degree) const {
    const int joint = joint_of(degree);
    return joint < 0 ? 0.0 : body().state.drive_end[joint];
}

double PlanarScene::largest_target_change() const {
    const int bodies = body().model.body_count;
    const MotorDrive& drive = body().forcing.drive;
    Simd4d largest = {};
    for (int i = 0; i < bodies; i += kLanes)
        largest =
            greater(magnitude(load_lanes(drive.end + i) - load_lanes(drive.start + i)), largest);
    return largest_of(largest);
}

SceneStatus PlanarScene::advance(double duration) {
    CAMBRIAN_ASSERT(duration > 0.0, "a tick takes time");
    if (body().state.status != SceneStatus::kRunning) return body().state.status;
    begin_tick(*body_);
    workspace_->control.advance(body().model, body().law, body().forcing, duration, body().state);
    end_tick(*body_);
    return body().state.status;
}

void PlanarScene::use_environment(const Environment& environment) {
    if (environment.terrain != environment_.terrain) {
        auto terrain = Terrain::make(environment.terrain);
        terrain_ = terrain ? *terrain : nullptr;
    }
    environment_ = environment;
    if (environment.density != body().model.density) {
        change_density(body().model, environment.density);
        packed_.forget_model();
        body().state.known_spins = 0;
    }
    body().forcing.medium = medium_of(environment);
    body().law = {body().motors_off ? 0.0 : environment.friction, environment.elasticity,
                  environment.has_ground, body().law.fixed, terrain_.get()};
    body().state.cache_is_current = false;
}

// Updates the cache for displays; time does not pass.
void PlanarScene::evaluate_here() const {
    body().forcing.held = nullptr;
    evaluate_accelerations(body().model, body().forcing, body().state.motion, {},
                           body().state.cache(), body().state.free_rate);
}

void PlanarScene::set_environment(const Environment& environment) {
    const double before = energy();
    use_environment(environment);
    body().state.energy_reference += energy() - before;
}

void PlanarScene::set_fixed_boxes(std::span<const FixedBox> boxes) {
    if (body_ == nullptr) {
        packed_.law().fixed = boxes;
        return;
    }
    body_->law.fixed = boxes;
    body_->state.detection = 0;
}

// With frequency 0 targets and rates cause no effort. The share of the strength in torque mode is 0
// while the motors are off.
void PlanarScene::set_motors_off(bool off) {
    body().motors_off = off;
    body().forcing.drive.frequency = off ? 0.0 : motor_frequency_;
    use_environment(environment_);
}

void PlanarScene::translate(const Vec3& offset) {
    const double before = energy();
    for (int t = 0; t < body().model.tree_count; ++t) {
        body().state.motion.position[center_of(body().model, t)] += offset.x();
        body().state.motion.position[center_of(body().model, t) + 1] += offset.y();
    }
    evaluate_here();
    body().state.cache_is_current = false;
    body().state.energy_reference += energy() - before;
}

void PlanarScene::pull(std::size_t part, const Vec3& point_in_part, const Vec3& force) {
    const Vec3 present = part_half_extents(part);
    const double x = point_in_part.x() * (body().model.half_length[part] / present.x());
    const double y = point_in_part.y() * (body().model.half_width[part] / present.y());
    if (body().forcing.pulls.size() == kMostPulls) return;
    HeldForce& pull = body().forcing.pulls.emplace_back();
    pull.body_a = body_of(part);
    pull.body_b = -1;
    pull.point_x = body().model.part_x[part] + body().model.part_cosine[part] * x -
                   body().model.part_sine[part] * y;
    pull.point_y = body().model.part_y[part] + body().model.part_sine[part] * x +
                   body().model.part_cosine[part] * y;
    pull.force_x = force.x();
    pull.force_y = force.y();
    body().state.cache_is_current = false;
}

void PlanarScene::mark() {
    if (!mark_) mark_ = std::make_unique<Mark>();
    if (body_ == nullptr)
        mark_->moment = packed_.moment();
    else
        pack_moment(*body_, mark_->moment);
    mark_->pulls = body_ == nullptr ? packed_.pulls() : body_->forcing.pulls;
}

void PlanarScene::go_back() {
    CAMBRIAN_ASSERT(mark_ != nullptr, "a marked moment");
    if (body_ == nullptr) {
        packed_.moment() = mark_->moment;
        packed_.pulls() = mark_->pulls;
        is_stale_ = true;
        return;
    }
    unpack_moment(mark_->moment, *body_);
    body_->forcing.pulls.clear();
    evaluate_here();
    body_->state.cache_is_current = false;
    body_->state.detection = 0;
    body_->forcing.pulls = mark_->pulls;
}

void PlanarScene::restore(const SceneState& state) {
    const auto* saved = dynamic_cast<const SavedState*>(&state);
    CAMBRIAN_ASSERT(saved != nullptr, "a state saved by a planar scene");
    body().state = saved->state;
    body().state.detection = 0;  // numbers of detections differ between scenes
    body().forcing.pulls.clear();
    if (saved->environment == environment_ && saved->motors_off == body().motors_off) return;
    body().state.cache_is_current = false;
    body().state.known_spins = 0;
    body().state.energy_reference += energy() - energy_under(saved->environment);
}

void PlanarScene::give_workspace(std::unique_ptr<SceneWorkspace> workspace) {
    CAMBRIAN_ASSERT(dynamic_cast<StepWorkspace*>(workspace.get()) != nullptr,
                    "a workspace of a planar scene");
    if (body_ != nullptr) pack();
    workspace_.reset(static_cast<StepWorkspace*>(workspace.release()));
    unpack_into(workspace_->room(0));
    workspace_->control.change_model(body_->model);
    body_->state.detection = 0;  // numbers of detections differ between workspaces
}

std::unique_ptr<SceneWorkspace> PlanarScene::take_workspace() {
    if (body_ != nullptr) pack();
    return std::move(workspace_);
}

SceneMotion PlanarScene::motion() const {
    if (body_ == nullptr) return packed_.motion();
    const auto count = static_cast<std::size_t>(coordinate_count(body_->model));
    const auto bodies = static_cast<std::size_t>(size_.bodies);
    return {{body_->state.motion.position, body_->state.motion.position + count},
            {body_->state.motion.speed, body_->state.motion.speed + count},
            {body_->state.drive_end, body_->state.drive_end + bodies}};
}

bool PlanarScene::begin_at(const SceneMotion& motion) {
    const auto count = static_cast<std::size_t>(coordinate_count(body().model));
    const auto bodies = static_cast<std::size_t>(body().model.body_count);
    if (motion.positions.size() != count || motion.speeds.size() != count ||
        motion.targets.size() != bodies)
        return false;
    const auto finite = [](const std::vector<double>& numbers) {
        return std::all_of(numbers.begin(), numbers.end(),
                           [](double number) { return std::isfinite(number); });
    };
    if (!finite(motion.positions) || !finite(motion.speeds) || !finite(motion.targets))
        return false;
    body().state = SimulationState{};
    body().state.motion = rest_motion(body().model);
    std::copy(motion.positions.begin(), motion.positions.end(), body().state.motion.position);
    std::copy(motion.speeds.begin(), motion.speeds.end(), body().state.motion.speed);
    std::copy(motion.targets.begin(), motion.targets.end(), body().state.drive_start);
    std::copy(motion.targets.begin(), motion.targets.end(), body().state.drive_end);
    body().forcing.pulls.clear();
    evaluate_here();
    note_speeds(body().model, body().state.cache().kinematics, body().state.forces);
    start_audit(body().model, body().forcing.medium, body().state);
    return true;
}

// Mechanical energy of the motion with another environment's density and gravity.
double PlanarScene::energy_under(const Environment& environment) const {
    const double here = mechanical_energy(body().model, medium_of(environment), body().state.motion,
                                          kinetic_energy());
    return here * (environment.density / body().model.density);
}

void PlanarScene::list_contacts(std::vector<SceneContact>& contacts) const {
    contacts.clear();
    const SimulationState& state = body().state;
    const Kinematics& k = state.cache().kinematics;
    for (int c = 0; c < state.held_count; ++c) {
        const HeldContact& held = state.held[c];
        const int a = held.body_a;
        double point_x = held.point_x;
        double point_y = held.point_y;
        stretch_point(k, a, point_x, point_y);
        const double x = k.x[a] + k.cosine[a] * point_x - k.sine[a] * point_y;
        const double y = k.y[a] + k.sine[a] * point_x + k.cosine[a] * point_y;
        contacts.push_back({Vec3(x, y, 0.0), Vec3(held.normal_x, held.normal_y, 0.0), held.force});
    }
}

void PlanarScene::list_impacts(std::vector<SceneImpact>& impacts) const {
    impacts.clear();
    const SimulationState& state = body().state;
    for (int i = 0; i < state.impact_count; ++i) {
        const NotedImpact& noted = state.impacts[i];
        if (!(noted.impulse > 0.0)) continue;
        const Vec3 weighted(noted.point_x, noted.point_y, 0.0);
        impacts.push_back({weighted / noted.impulse, noted.part_a, noted.part_b, noted.impulse,
                           noted.lost, noted.other});
    }
}

void PlanarScene::add_to_digest(Hash64& digest) const {
    const SceneBody& own = body();
    for (int c = 0; c < coordinate_count(own.model); ++c) {
        digest.add(own.state.motion.position[c]);
        digest.add(own.state.motion.speed[c]);
    }
}

Status check_surroundings(const Environment& environment, const SceneSettings& settings) {
    const double numbers[] = {environment.gravity,          environment.gravity_direction,
                              environment.friction,         environment.elasticity,
                              environment.viscosity_linear, environment.viscosity_quadratic,
                              settings.motor_speed_limit,   settings.motor_frequency};
    for (const double number : numbers) {
        if (!std::isfinite(number)) return Error{"environment: a number is not finite"};
    }
    for (const double positive :
         {settings.tolerance, settings.contact_step, settings.max_evaluations}) {
        if (!(positive > 0.0))
            return Error{"scene settings: tolerance, contact step and evaluations must be above 0"};
    }
    return {};
}

Error unknown_integrator(const std::string& id) {
    const std::vector<std::string> known = integrator_ids();
    const std::string nearest = nearest_name(id, known);
    std::string message = fmt::format("scene settings: unknown integrator \"{}\"", id);
    message += nearest.empty() ? "; known are" : fmt::format("; did you mean \"{}\"?", nearest);
    if (!nearest.empty()) return {message};
    for (const std::string& name : known)
        message += fmt::format(" \"{}\"", name);
    return {message};
}

bool deforms(const BodyPlan& plan) {
    return std::any_of(plan.parts.begin(), plan.parts.end(),
                       [](const PlannedPart& part) { return part.stretch.has_value(); });
}

Error need_another_integrator(const std::string& id) {
    std::string message =
        fmt::format("body plan: deformable parts need another integrator than \"{}\":", id);
    for (const IntegratorKind& integrator : builtin_integrators().all()) {
        if (integrator.holds_stretches) message += fmt::format(" \"{}\"", integrator.id);
    }
    return {message};
}

}  // namespace

Result<std::unique_ptr<PhysicsScene>> CAMBRIAN_SCENE_COPY::make_planar_scene(
    const BodyPlan& plan, const Environment& environment, const SceneSettings& settings) {
    const IntegratorKind* integrator = builtin_integrators().find(settings.integrator);
    if (integrator == nullptr) return unknown_integrator(settings.integrator);
    if (deforms(plan) && !integrator->holds_stretches)
        return need_another_integrator(integrator->id);
    if (Status status = check_surroundings(environment, settings); !status) return status.error();
    Result<PlanarModel> model = build_planar_model(plan, environment.density);
    if (!model) return model.error();
    auto terrain = Terrain::make(environment.terrain);
    if (!terrain) return Error{"environment: " + terrain.error().message};
    return std::unique_ptr<PhysicsScene>(std::make_unique<PlanarScene>(
        std::move(*model), ShapedWorld{environment, *std::move(terrain)}, settings, *integrator));
}

std::unique_ptr<JoinedScenes> CAMBRIAN_SCENE_COPY::join_planar_scenes(
    std::span<PhysicsScene* const> scenes) {
    return join_body_scenes(scenes);
}

}  // namespace cambrian
