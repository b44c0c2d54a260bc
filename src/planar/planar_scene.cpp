#include "core/assert.h"
#include "math/angle.h"
#include "planar/integrators/builtin_integrators.h"
#include "planar/kept_scene.h"
#include "planar/model_building.h"
#include "planar/scene_copies.h"
#include "planar/stepping/audit.h"
#include "world/scene_checks.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
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

// An environment with the ground that its settings describe.
struct ShapedWorld {
    const Environment& environment;
    std::shared_ptr<const Terrain> terrain;
};

class PlanarScene final : public KeptScene {
public:
    PlanarScene(PlanarModel&& model, const ShapedWorld& world, const SceneSettings& settings,
                const IntegratorKind& integrator)
        : KeptScene(std::move(model), settings, integrator),
          motor_frequency_(settings.motor_frequency),
          environment_(world.environment),
          terrain_(world.terrain) {
        body().forcing.drive.frequency = motor_frequency_;
        body().forcing.drive.speed_limit = settings.motor_speed_limit;
        use_environment(world.environment);
        evaluate_here();
        restart_audit();
    }

    void set_target(const JointDegree& degree, double target) override;
    void set_stretch_target(std::size_t part, double target) override;
    SceneStatus advance(double duration) override;
    void set_environment(const Environment& environment) override;
    void set_fixed_boxes(std::span<const FixedBox> boxes) override;
    void set_motors_off(bool off) override;
    void translate(const Vec3& offset) override;
    void pull(std::size_t part, const Vec3& point_in_part, const Vec3& force) override;
    std::unique_ptr<SceneState> save() const override {
        return std::make_unique<SavedState>(body().state, environment_, body().motors_off);
    }
    void restore(const SceneState& state) override;
    bool begin_at(const SceneMotion& motion) override;
    void restart_audit() override {
        start_audit(body().model, body().forcing.medium, body().state);
    }

private:
    void set_slot_target(int slot, double target);
    void use_environment(const Environment& environment);
    double energy_under(const Environment& environment) const;

    double motor_frequency_;
    Environment environment_;
    std::shared_ptr<const Terrain> terrain_;  // of the environment; null if the ground is flat
};

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

SceneStatus PlanarScene::advance(double duration) {
    CAMBRIAN_ASSERT(duration > 0.0, "a tick takes time");
    if (body().state.status != SceneStatus::kRunning) return body().state.status;
    begin_tick(body());
    control().advance(body().model, body().law, body().forcing, duration, body().state);
    end_tick(body());
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
        packed().forget_model();
        body().state.known_spins = 0;
    }
    body().forcing.medium = medium_of(environment);
    body().law = {body().motors_off ? 0.0 : environment.friction, environment.elasticity,
                  environment.has_ground, body().law.fixed, terrain_.get()};
    body().state.cache_is_current = false;
}

void PlanarScene::set_environment(const Environment& environment) {
    const double before = energy();
    use_environment(environment);
    body().state.energy_reference += energy() - before;
}

void PlanarScene::set_fixed_boxes(std::span<const FixedBox> boxes) {
    if (is_packed()) {
        packed().law().fixed = boxes;
        return;
    }
    body().law.fixed = boxes;
    body().state.detection = 0;
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

bool PlanarScene::begin_at(const SceneMotion& motion) {
    const auto count = static_cast<std::size_t>(coordinate_count(body().model));
    const auto bodies = static_cast<std::size_t>(body().model.body_count);
    if (!has_numbers(motion, count, count, bodies)) return false;
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
    if (integrator == nullptr) return unknown_integrator(settings.integrator, integrator_ids());
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
