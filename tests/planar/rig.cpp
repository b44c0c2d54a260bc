#include "planar/rig.h"

#include "math/angle.h"

#include <cmath>
#include <stdexcept>

namespace cambrian {
namespace {

PlanarModel built(const BodyPlan& plan, double density) {
    auto model = build_planar_model(plan, density);
    if (!model) throw std::runtime_error(model.error().message);
    return *model;
}

SceneSettings settings_with(double tolerance, double contact_step) {
    SceneSettings settings;
    settings.tolerance = tolerance;
    settings.contact_step = contact_step;
    return settings;
}

const IntegratorKind& found(const std::string& id) {
    const IntegratorKind* kind = builtin_integrators().find(id);
    if (kind == nullptr) throw std::runtime_error("unknown integrator " + id);
    return *kind;
}

}  // namespace

Rig::Rig(const BodyPlan& plan, const Environment& environment, const std::string& integrator,
         double tolerance, double contact_step)
    : model(built(plan, environment.density)),
      law{environment.friction, environment.elasticity, environment.has_ground},
      control(found(integrator), settings_with(tolerance, contact_step)) {
    const SineCosine turn = sine_cosine_of_degrees(environment.gravity_direction);
    forcing.medium = {environment.gravity * turn.cosine, environment.gravity * turn.sine,
                      environment.viscosity_linear, environment.viscosity_quadratic};
    forcing.drive.frequency = SceneSettings{}.motor_frequency;
    forcing.drive.speed_limit = SceneSettings{}.motor_speed_limit;
    state.motion = rest_motion(model);
}

void Rig::begin() {
    evaluate_accelerations(model, forcing, state.motion, {}, state.cache(), state.free_rate);
    start_audit(model, forcing.medium, state);
}

bool Rig::run(double duration) {
    const int ticks = static_cast<int>(std::lround(duration / kTestTick));
    for (int i = 0; i < ticks; ++i) {
        control.advance(model, law, forcing, kTestTick, state);
        if (state.status != SceneStatus::kRunning) return false;
    }
    return true;
}

double Rig::energy() const {
    return mechanical_energy(model, forcing.medium, state.motion,
                             kinetic_energy(model, state.cache().kinematics));
}

double Rig::angular_momentum() const {
    const Kinematics& k = state.cache().kinematics;
    double sum = 0.0;
    for (int i = 0; i < model.body_count; ++i)
        sum += model.inertia[i] * k.spin[i] +
               model.mass[i] * (k.x[i] * k.velocity_y[i] - k.y[i] * k.velocity_x[i]);
    return sum;
}

double Rig::speed() const {
    double largest = 0.0;
    for (int c = 0; c < coordinate_count(model); ++c)
        largest = std::fmax(largest, std::fabs(state.motion.speed[c]));
    return largest;
}

}  // namespace cambrian
