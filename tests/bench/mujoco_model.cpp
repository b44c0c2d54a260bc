#include "bench/mujoco_model.h"

#include "bench/pair_filter.h"
#include "core/assert.h"
#include "math/angle.h"
#include "support/body_plans.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

namespace cambrian::bench {
namespace {

constexpr double kHalfDepth = 0.05;      // m; depth of boxes out of the plane
constexpr const char* kAxis = "0 -1 0";  // counter-clockwise seen with x to the right and z upwards
constexpr const char* kFile = "body.xml";  // name in MuJoCo's virtual file system

const char* integrator_name(MujocoIntegrator integrator) {
    switch (integrator) {
        case MujocoIntegrator::kEuler:
            return "Euler";
        case MujocoIntegrator::kRungeKutta4:
            return "RK4";
        case MujocoIntegrator::kImplicit:
            return "implicit";
    }
    return "";
}

class ModelText {
public:
    ModelText(const BodyPlan& plan, const Environment& environment, const MujocoSettings& settings)
        : plan_(plan), environment_(environment) {
        constexpr int digits = 17;
        text_.precision(digits);
        text_ << "<mujoco><compiler angle='radian' inertiafromgeom='true'/>";
        write_options(settings);
        text_ << "<size njmax='1000' nconmax='250'/>";
        write_surfaces();
        text_ << "<worldbody>";
        if (environment.has_ground) text_ << "<geom name='ground' type='plane' size='0 0 1'/>";
        write_body(0);
        text_ << "</worldbody>";
        write_exclusions();
        write_actuators();
        text_ << "</mujoco>";
    }

    std::string str() const { return text_.str(); }

private:
    void write_options(const MujocoSettings& settings) {
        const double direction = to_radians(environment_.gravity_direction);
        text_ << "<option timestep='" << kTestTick / settings.steps_per_tick << "' integrator='"
              << integrator_name(settings.integrator) << "' gravity='"
              << environment_.gravity * std::cos(direction) << " 0 "
              << environment_.gravity * std::sin(direction) << "'/>";
    }

    // MuJoCo has no coefficient of restitution, so its soft contacts keep their default.
    void write_surfaces() {
        text_ << "<default><geom friction='" << environment_.friction
              << " 0.005 0.0001'/></default>";
    }

    // Writes the part's position and rotation relative to its parent's frame at rest.
    void write_body(std::size_t index) {
        const PlannedPart& part = plan_.parts[index];
        const Vec3 world = part.rest_pose.position;
        text_ << "<body name='" << mujoco_name(index) << "' pos='";
        if (index == 0) {
            text_ << world.x() << " 0 " << world.y() << "'>"
                  << "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 0 1'/>"
                  << "<joint name='" << mujoco_name(0) << "' type='hinge' axis='" << kAxis << "'/>";
        } else {
            const PlannedPart& parent = plan_.parts[static_cast<std::size_t>(part.parent)];
            const Vec3 offset =
                parent.rest_pose.orientation.conjugate() * (world - parent.rest_pose.position);
            const double half_turn = 0.5 * (part.rest_angle - parent.rest_angle);
            text_ << offset.x() << " 0 " << offset.y() << "' quat='" << std::cos(half_turn) << " 0 "
                  << -std::sin(half_turn) << " 0'>";
            write_joint(index);
        }
        write_box(index);
        for (std::size_t child = index + 1; child < plan_.parts.size(); ++child) {
            if (plan_.parts[child].parent == static_cast<int>(index)) write_body(child);
        }
        text_ << "</body>";
    }

    void write_joint(std::size_t index) {
        const PlannedPart& part = plan_.parts[index];
        text_ << "<joint name='" << mujoco_name(index) << "' type='hinge' axis='" << kAxis
              << "' pos='" << part.anchor_in_child.x() << " 0 " << part.anchor_in_child.y()
              << "' limited='true' range='" << part.limit_low << " " << part.limit_high << "'/>";
    }

    void write_box(std::size_t index) {
        const Vec3& half = plan_.parts[index].half_extents;
        text_ << "<geom name='" << mujoco_name(index) << "' type='box' size='" << half.x() << " "
              << kHalfDepth << " " << half.y() << "' mass='"
              << 4 * environment_.density * half.x() * half.y() << "'/>";
    }

    void write_exclusions() {
        const PairFilter pairs(plan_);
        text_ << "<contact>";
        for (std::size_t a = 0; a < plan_.parts.size(); ++a) {
            for (std::size_t b = a + 1; b < plan_.parts.size(); ++b) {
                if (!pairs.may_touch(a, b))
                    text_ << "<exclude body1='" << mujoco_name(a) << "' body2='" << mujoco_name(b)
                          << "'/>";
            }
        }
        text_ << "</contact>";
    }

    void write_actuators() {
        text_ << "<actuator>";
        for (std::size_t i = 1; i < plan_.parts.size(); ++i) {
            const double cap = plan_.parts[i].max_effort;
            text_ << "<general joint='" << mujoco_name(i)
                  << "' biastype='affine' forcelimited='true'"
                  << " forcerange='" << -cap << " " << cap << "'/>";
        }
        text_ << "</actuator>";
    }

    const BodyPlan& plan_;
    const Environment& environment_;
    std::ostringstream text_;
};

// Sets effort = 2 I_eff w (wanted rate - rate), or max_effort * share in torque mode.
void set_gains(const BodyPlan& plan, mjModel& model) {
    const SceneSettings motors;
    for (std::size_t i = 1; i < plan.parts.size(); ++i) {
        const std::size_t actuator = i - 1;
        const int joint = mj_name2id(&model, mjOBJ_JOINT, mujoco_name(i).c_str());
        const double mobility = model.dof_invweight0[model.jnt_dofadr[joint]];  // 1 / I_eff
        const bool torque = plan.parts[i].motor_mode == MotorMode::kTorque;
        const double gain = 2 * motors.motor_frequency / mobility;
        model.actuator_gainprm[actuator * mjNGAIN] = torque ? plan.parts[i].max_effort : gain;
        model.actuator_biasprm[actuator * mjNBIAS + 2] = torque ? 0.0 : -gain;
    }
}

void report_warning(const char* message) {
    std::fprintf(stderr, "MuJoCo: %s\n", message);
}

}  // namespace

std::string mujoco_name(std::size_t part) {
    std::string name = std::to_string(part);
    name.insert(name.begin(), 'p');
    return name;
}

MujocoModel load_mujoco_model(const std::string& text) {
    mju_user_warning = report_warning;
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), kFile, static_cast<int>(text.size()));
    text.copy(static_cast<char*>(files->filedata[0]), text.size());
    constexpr int message_size = 1000;
    char message[message_size] = "";
    MujocoModel model(mj_loadXML(kFile, files.get(), message, message_size));
    mj_deleteVFS(files.get());
    if (!model) {
        std::fprintf(stderr, "MuJoCo refuses the model: %s\n", message);
        std::abort();
    }
    return model;
}

MujocoModel build_mujoco_model(const BodyPlan& plan, const Environment& environment,
                               const MujocoSettings& settings) {
    CAMBRIAN_ASSERT(plan.parts.front().rest_angle == 0.0, "the root's slides are the world's axes");
    MujocoModel model = load_mujoco_model(ModelText(plan, environment, settings).str());
    set_gains(plan, *model);
    return model;
}

}  // namespace cambrian::bench
