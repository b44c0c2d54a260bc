#include "planar/kept_scene.h"

#include "math/angle.h"
#include "planar/contact/terrain_contacts.h"
#include "planar/model/stretching.h"

#include <limits>

namespace cambrian {
namespace {

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

}  // namespace

KeptScene::KeptScene(PlanarModel&& model, const SceneSettings& settings,
                     const IntegratorKind& integrator)
    : size_{model.body_count, model.tree_count, model.part_count},
      workspace_(std::make_unique<StepWorkspace>(integrator, settings)),
      body_(&workspace_->room(0)) {
    body_->model = std::move(model);
    workspace_->control.change_model(body_->model);
    body_->state.motion = rest_motion(body_->model);
}

void KeptScene::pack() const {
    packed_.pack(*body_);
    body_ = nullptr;
    own_.reset();
}

void KeptScene::unpack_into(SceneBody& room) const {
    packed_.unpack(room);
    body_ = &room;
    if (!std::exchange(is_stale_, false)) return;
    evaluate_here();
    body_->state.cache_is_current = false;
}

void KeptScene::unpack_alone() const {
    own_ = std::make_unique<SceneBody>();
    unpack_into(*own_);
}

SceneBody& KeptScene::open(SceneBody& room) {
    if (body_ == nullptr) unpack_into(room);
    return *body_;
}

void KeptScene::close() {
    if (!workspace_) pack();
}

void KeptScene::mark() {
    if (!mark_) mark_ = std::make_unique<Mark>();
    if (body_ == nullptr)
        mark_->moment = packed_.moment();
    else
        pack_moment(*body_, mark_->moment);
    mark_->pulls = body_ == nullptr ? packed_.pulls() : body_->forcing.pulls;
}

void KeptScene::go_back() {
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

void KeptScene::give_workspace(std::unique_ptr<SceneWorkspace> workspace) {
    CAMBRIAN_ASSERT(dynamic_cast<StepWorkspace*>(workspace.get()) != nullptr,
                    "a workspace of a planar scene");
    if (body_ != nullptr) pack();
    workspace_.reset(static_cast<StepWorkspace*>(workspace.release()));
    unpack_into(workspace_->room(0));
    workspace_->control.change_model(body_->model);
    body_->state.detection = 0;  // numbers of detections differ between workspaces
}

std::unique_ptr<SceneWorkspace> KeptScene::take_workspace() {
    if (body_ != nullptr) pack();
    return std::move(workspace_);
}

SceneMotion KeptScene::motion() const {
    if (body_ == nullptr) return packed_.motion();
    const auto count = static_cast<std::size_t>(coordinate_count(body_->model));
    const auto bodies = static_cast<std::size_t>(size_.bodies);
    return {{body_->state.motion.position, body_->state.motion.position + count},
            {body_->state.motion.speed, body_->state.motion.speed + count},
            {body_->state.drive_end, body_->state.drive_end + bodies}};
}

void KeptScene::evaluate_here() const {
    body().forcing.held = nullptr;
    evaluate_accelerations(body().model, body().forcing, body().state.motion, {},
                           body().state.cache(), body().state.free_rate);
}

Vec2 KeptScene::arm_of(std::size_t part) const {
    const PlanarModel& model = body().model;
    const Simd2d arm = material_arm(body().state.cache().kinematics, model.part_body[part],
                                    model.part_x[part], model.part_y[part]);
    return {arm[0], arm[1]};
}

Pose KeptScene::part_pose(std::size_t part) const {
    const Vec3 center = part_center(part);
    const double angle =
        body().state.cache().kinematics.angle[body_of(part)] + body().model.part_angle[part];
    return planar_pose(center.x(), center.y(), angle);
}

Vec3 KeptScene::part_center(std::size_t part) const {
    const int b = body_of(part);
    const Kinematics& k = body().state.cache().kinematics;
    const Vec2 arm = arm_of(part);
    return {k.x[b] + arm.x(), k.y[b] + arm.y(), 0.0};
}

Vec3 KeptScene::part_axis(std::size_t part) const {
    const int b = body_of(part);
    const Kinematics& k = body().state.cache().kinematics;
    const double cosine = body().model.part_cosine[part];
    const double sine = body().model.part_sine[part];
    return {k.cosine[b] * cosine - k.sine[b] * sine, k.sine[b] * cosine + k.cosine[b] * sine, 0.0};
}

Twist KeptScene::part_twist(std::size_t part) const {
    const int b = body_of(part);
    const Kinematics& k = body().state.cache().kinematics;
    const Vec2 arm = arm_of(part);
    return {Vec3(k.velocity_x[b] - k.spin[b] * arm.y(), k.velocity_y[b] + k.spin[b] * arm.x(), 0.0),
            Vec3(0.0, 0.0, k.spin[b])};
}

Vec3 KeptScene::part_half_extents(std::size_t part) const {
    const int b = body_of(part);
    Vec3 rest(body().model.half_length[part], body().model.half_width[part], 0.0);
    if (body().model.stretch_slot[b] < 0) return rest;
    const Kinematics& k = body().state.cache().kinematics;
    return {k.length_growth[b] * rest.x(), k.width_growth[b] * rest.y(), 0.0};
}

Vec3 KeptScene::mean_of_trees(const PerCoordinate& coordinates) const {
    const PlanarModel& model = body().model;
    Vec3 mean = Vec3::Zero();
    for (int t = 0; t < model.tree_count; ++t) {
        const int center = center_of(model, t);
        const double share = model.tree_mass[t] / model.total_mass;
        mean += share * Vec3(coordinates[center], coordinates[center + 1], 0.0);
    }
    return mean;
}

Bounds KeptScene::bounds() const {
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

double KeptScene::lowest_point() const {
    const PlanarModel& model = body().model;
    const Kinematics& k = body().state.cache().kinematics;
    Simd4d low = all_lanes(std::numeric_limits<double>::infinity());
    for (int part = 0; part < model.part_count; ++part) {
        const Corners corners = corners_of(model, k, part);
        low = lesser(heights_of(corners, k, model.part_body[part]), low);
    }
    return -largest_of(-low);
}

double KeptScene::ground_gap() const {
    const Terrain* terrain = body().law.terrain;
    if (terrain == nullptr) return lowest_point();
    const Kinematics& k = body().state.cache().kinematics;
    PartPlaces places;
    place_parts(body().model, k, places);
    return height_above_terrain(body().model, places, *terrain);
}

void KeptScene::list_contacts(std::vector<SceneContact>& contacts) const {
    const SimulationState& state = body().state;
    contacts.clear();
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

void KeptScene::list_impacts(std::vector<SceneImpact>& impacts) const {
    const SimulationState& state = body().state;
    impacts.clear();
    for (int i = 0; i < state.impact_count; ++i) {
        const NotedImpact& noted = state.impacts[i];
        if (!(noted.impulse > 0.0)) continue;
        const Vec3 weighted(noted.point_x, noted.point_y, 0.0);
        impacts.push_back({weighted / noted.impulse, noted.part_a, noted.part_b, noted.impulse,
                           noted.lost, noted.other});
    }
}

void KeptScene::list_joint_coordinates(std::span<const JointDegree> degrees,
                                       std::span<double> coordinates) const {
    CAMBRIAN_ASSERT(coordinates.size() == degrees.size(), "a place for each coordinate");
    const PerBody& positions = body().state.cache().kinematics.joint_position;
    double* coordinate = coordinates.data();
    for (const JointDegree& degree : degrees) {
        const int joint = joint_of(degree);
        *coordinate++ = joint < 0 ? 0.0 : positions[joint];
    }
}

bool KeptScene::face_touched(std::size_t part, Face face) const {
    CAMBRIAN_ASSERT(part < part_count(), "part index in range");
    return ((body().state.touched[part] >> static_cast<unsigned>(face)) & 1U) != 0;
}

Vec3 KeptScene::part_specific_force(std::size_t part) const {
    CAMBRIAN_ASSERT(part < part_count(), "part index in range");
    return {body().state.forces.specific_x[part], body().state.forces.specific_y[part], 0.0};
}

double KeptScene::part_load(std::size_t part) const {
    CAMBRIAN_ASSERT(part < part_count(), "part index in range");
    return body().state.forces.load[part];
}

double KeptScene::largest_target_change() const {
    const int bodies = body().model.body_count;
    const MotorDrive& drive = body().forcing.drive;
    Simd4d largest = {};
    for (int i = 0; i < bodies; i += kLanes)
        largest =
            greater(magnitude(load_lanes(drive.end + i) - load_lanes(drive.start + i)), largest);
    return largest_of(largest);
}

void KeptScene::add_to_digest(Hash64& digest) const {
    const SceneBody& own = body();
    for (int c = 0; c < coordinate_count(own.model); ++c) {
        digest.add(own.state.motion.position[c]);
        digest.add(own.state.motion.speed[c]);
    }
}

}  // namespace cambrian
