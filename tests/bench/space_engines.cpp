// cambrian_bench_space: runs the same creatures of boxes in our physics of space and in MuJoCo, in
// one thread. Prints CPU time per simulated second and its ratio to ours; count_instructions.sh
// counts its instructions. Parts do not touch one another.

#include "bench/cell_options.h"
#include "bench/motor_law.h"
#include "bench/mujoco_model.h"
#include "bench/selection.h"
#include "core/random.h"
#include "core/sample_statistics.h"
#include "core/thread_time.h"
#include "math/elementary.h"
#include "spatial/spatial_scene.h"
#include "support/body_plans.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

namespace cambrian::bench {
namespace {

// ---- Creatures ----

struct Swing {
    JointDegree degree;
    double middle = 0.0, half_range = 0.0;  // rad or m
    double frequency = 0.0, phase = 0.0;    // Hz, rad

    double target(std::size_t tick) const {
        return middle +
               half_range *
                   sine(2 * kPi * frequency * static_cast<double>(tick) * kTestTick + phase);
    }
};

struct SpaceCreature {
    BodyPlan plan;
    std::vector<Swing> swings;
};

Rotation random_turn(RandomStream& random, double largest) {
    const SineCosine roll = sine_cosine(0.5 * random.uniform(-largest, largest));
    const SineCosine yaw = sine_cosine(0.5 * random.uniform(-largest, largest));
    const SineCosine bend = sine_cosine(0.5 * random.uniform(-largest, largest));
    return Rotation(roll.cosine, roll.sine, 0.0, 0.0) * Rotation(yaw.cosine, 0.0, yaw.sine, 0.0) *
           Rotation(bend.cosine, 0.0, 0.0, bend.sine);
}

Vec3 random_half_extents(RandomStream& random) {
    // Braces, so that every compiler draws in this order.
    return Vec3{random.uniform(0.1, 0.35), random.uniform(0.04, 0.1), random.uniform(0.04, 0.1)};
}

PlannedPart random_limb(RandomStream& random, const BodyPlan& plan, const JointRegistry& joints) {
    constexpr double muscle_strength = 25'000.0;  // N/m^2
    const std::size_t last = plan.parts.size() - 1;
    const std::size_t parent = random.chance(1.0 / 3) ? random.below(plan.parts.size()) : last;
    const PlannedPart& from = plan.parts[parent];
    PlannedPart part;
    part.half_extents = random_half_extents(random);
    part.parent = static_cast<int>(parent);
    part.anchor_in_parent = Vec3{from.half_extents.x(), 0.9 * from.half_extents.y(), 0.0};
    part.anchor_in_parent.y() *= random.uniform(-1.0, 1.0);
    part.anchor_in_parent.z() = random.uniform(-0.9, 0.9) * from.half_extents.z();
    part.anchor_in_child = Vec3(-part.half_extents.x(), 0.0, 0.0);
    part.rest_pose.orientation =
        (from.rest_pose.orientation * random_turn(random, 0.7)).normalized();
    part.rest_pose.position = transform(from.rest_pose, part.anchor_in_parent);
    part.rest_pose.position = transform(part.rest_pose, -part.anchor_in_child);
    JointGenes genes;
    genes.limit_low = -random.uniform(0.4, 1.2);
    genes.limit_high = random.uniform(0.4, 1.2);
    for (auto& limits : genes.further_limits)
        limits = {-random.uniform(0.4, 1.2), random.uniform(0.4, 1.2)};
    genes.length = 2.0 * part.half_extents.x();
    genes.width = 2.0 * std::fmin(part.half_extents.y(), from.half_extents.y());
    genes.depth = 2.0 * std::fmin(part.half_extents.z(), from.half_extents.z());
    genes.muscle_strength = muscle_strength;
    const JointKind* joint = nullptr;
    do {
        joint = &joints[random.below(joints.size())];
    } while (joint->shape == nullptr || joint->motion == JointMotion::kBall);
    part.motion = joint->motion;
    joint->shape(genes, part);
    return part;
}

void add_swings(SpaceCreature& creature, RandomStream& random) {
    for (std::size_t i = 1; i < creature.plan.parts.size(); ++i) {
        for (std::size_t d = 0; d < degrees_of(creature.plan.parts[i]); ++d) {
            const DegreeLimits limits = limits_of(creature.plan.parts[i], d);
            Swing swing{{static_cast<std::uint16_t>(i), static_cast<std::uint8_t>(d)},
                        0.5 * (limits.high + limits.low),
                        0.5 * (limits.high - limits.low)};
            swing.frequency = random.uniform(0.3, 2.0);
            swing.phase = random.uniform(0.0, 2 * kPi);
            creature.swings.push_back(swing);
        }
    }
}

// Puts the lowest corner 2 cm above the ground.
void stand_plan(BodyPlan& plan) {
    double lowest = 0.0;
    for (const PlannedPart& part : plan.parts) {
        const Vec3 up = part.rest_pose.orientation.conjugate() * Vec3::UnitY();
        lowest =
            std::fmin(lowest, part.rest_pose.position.y() - up.cwiseAbs().dot(part.half_extents));
    }
    for (PlannedPart& part : plan.parts)
        part.rest_pose.position.y() += 0.02 - lowest;
}

// Returns a tree whose moving joints are of all kinds that space has but balls, whose targets
// MuJoCo has not. The motors swing every degree
// of freedom between its limits at 0.3 to 2 Hz.
SpaceCreature random_space_creature(std::size_t bodies, std::uint64_t seed) {
    static const JointRegistry joints = spatial_scene_kind().joints;
    RandomStream random(stream_seed(seed, bodies, 0, Purpose::kTest));
    SpaceCreature creature;
    creature.plan.parts.emplace_back();
    creature.plan.parts.front().half_extents = random_half_extents(random);
    creature.plan.parts.front().rest_pose.orientation = random_turn(random, 0.5).normalized();
    while (creature.plan.parts.size() < bodies)
        creature.plan.parts.push_back(random_limb(random, creature.plan, joints));
    stand_plan(creature.plan);
    add_swings(creature, random);
    return creature;
}

// ---- Worlds ----

struct SpaceWorkload {
    std::string id;  // "air", "swim", "walk"
    Environment environment;
};

std::vector<SpaceWorkload> space_workloads() {
    Environment air;
    air.dimensions = 3;
    air.density = 1000.0;
    air.has_ground = false;
    Environment water = air;
    water.gravity = 0.0;
    water.viscosity_quadratic = 1000.0;
    Environment land = air;
    land.has_ground = true;
    land.friction = 0.8;
    return {{"air", air}, {"swim", water}, {"walk", land}};
}

// ---- Engines ----

class SpaceEngine {
public:
    virtual ~SpaceEngine() = default;
    virtual void advance_tick(const SpaceCreature& creature, std::size_t tick) = 0;
};

class OurSpaceEngine final : public SpaceEngine {
public:
    OurSpaceEngine(const BodyPlan& plan, const Environment& environment)
        : scene_(spatial_scene_kind().make(plan, environment, {}).value()) {}

    void advance_tick(const SpaceCreature& creature, std::size_t tick) override {
        for (const Swing& swing : creature.swings)
            scene_->set_target(swing.degree, swing.target(tick));
        scene_->advance(kTestTick);
    }

private:
    std::unique_ptr<PhysicsScene> scene_;
};

// A body plan as MuJoCo's text. MuJoCo's exact cone has the name "elliptic". Its own medium serves
// water: twice our coefficient is the density with the same drag on a box that moves along an axis.
class SpaceModelText {
public:
    SpaceModelText(const SpaceCreature& creature, const Environment& environment, double step)
        : plan_(creature.plan), environment_(environment) {
        constexpr int digits = 17;
        text_.precision(digits);
        text_ << "<mujoco><compiler angle='radian' inertiafromgeom='true'/><option timestep='"
              << step << "' cone='elliptic' gravity='0 " << -environment.gravity << " 0' density='"
              << 2.0 * environment.viscosity_quadratic << "'/><size njmax='2000' nconmax='400'/>"
              << "<default><geom contype='1' conaffinity='0' friction='" << environment.friction
              << " 0.005 0.0001' density='" << environment.density << "'/></default><worldbody>";
        const SineCosine quarter = sine_cosine(kPi / 4);
        if (environment.has_ground)
            text_ << "<geom type='plane' size='0 0 1' contype='0' conaffinity='1' quat='"
                  << quarter.cosine << " " << -quarter.sine << " 0 0'/>";
        write_body(0);
        text_ << "</worldbody><actuator>";
        for (const Swing& swing : creature.swings) {
            const double cap =
                limits_of(plan_.parts[swing.degree.part], swing.degree.degree).max_effort;
            text_ << "<general joint='" << degree_name(swing.degree)
                  << "' biastype='affine' forcelimited='true' forcerange='" << -cap << " " << cap
                  << "'/>";
        }
        text_ << "</actuator></mujoco>";
    }

    std::string str() const { return text_.str(); }

    static std::string degree_name(const JointDegree& degree) {
        return "d" + std::to_string(degree.part) + "-" + std::to_string(degree.degree);
    }

private:
    void write_body(std::size_t index) {
        const PlannedPart& part = plan_.parts[index];
        Vec3 position = part.rest_pose.position;
        Rotation turn = part.rest_pose.orientation;
        if (index > 0) {
            const Pose& from = plan_.parts[static_cast<std::size_t>(part.parent)].rest_pose;
            position = from.orientation.conjugate() * (position - from.position);
            turn = from.orientation.conjugate() * turn;
        }
        text_ << "<body pos='" << position.x() << " " << position.y() << " " << position.z()
              << "' quat='" << turn.w() << " " << turn.x() << " " << turn.y() << " " << turn.z()
              << "'>";
        if (index == 0) text_ << "<freejoint/>";
        for (std::size_t d = 0; index > 0 && d < degrees_of(part); ++d)
            write_joint(index, d);
        const Vec3& half = part.half_extents;
        text_ << "<geom type='box' size='" << half.x() << " " << half.y() << " " << half.z()
              << "'/>";
        for (std::size_t child = index + 1; child < plan_.parts.size(); ++child) {
            if (plan_.parts[child].parent == static_cast<int>(index)) write_body(child);
        }
        text_ << "</body>";
    }

    void write_joint(std::size_t index, std::size_t degree) {
        static constexpr const char* axes[] = {"1 0 0", "0 1 0", "0 0 1"};
        const PlannedPart& part = plan_.parts[index];
        const bool slides = part.motion == JointMotion::kSlide;
        const DegreeLimits limits = limits_of(part, degree);
        const Vec3& anchor = part.anchor_in_child;
        text_ << "<joint name='"
              << degree_name({static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(degree)})
              << "' type='" << (slides ? "slide" : "hinge") << "' axis='"
              << axes[slides ? 0 : part.axes[degree]] << "' pos='" << anchor.x() << " "
              << anchor.y() << " " << anchor.z() << "' limited='true' range='" << limits.low << " "
              << limits.high << "'/>";
    }

    const BodyPlan& plan_;
    const Environment& environment_;
    std::ostringstream text_;
};

class MujocoSpaceEngine;
thread_local const MujocoSpaceEngine* driven_space_engine = nullptr;  // the one that advances now

class MujocoSpaceEngine final : public SpaceEngine {
public:
    MujocoSpaceEngine(const SpaceCreature& creature, const Environment& environment, int steps)
        : steps_(steps),
          model_(load_mujoco_model(SpaceModelText(creature, environment, kTestTick / steps).str())),
          data_(mj_makeData(model_.get())),
          targets_(creature.swings.size(), 0.0) {
        const SceneSettings motors;
        for (const Swing& swing : creature.swings) {
            const int joint = mj_name2id(model_.get(), mjOBJ_JOINT,
                                         SpaceModelText::degree_name(swing.degree).c_str());
            coordinate_.push_back(model_->jnt_qposadr[joint]);
            const double mobility = model_->dof_invweight0[model_->jnt_dofadr[joint]];
            const double gain = 2.0 * motors.motor_frequency / mobility;
            const std::size_t actuator = coordinate_.size() - 1;
            model_->actuator_gainprm[actuator * mjNGAIN] = gain;
            model_->actuator_biasprm[actuator * mjNBIAS + 2] = -gain;
        }
    }

    void advance_tick(const SpaceCreature& creature, std::size_t tick) override {
        for (std::size_t i = 0; i < targets_.size(); ++i)
            targets_[i] = creature.swings[i].target(tick);
        driven_space_engine = this;
        mjcb_control = &MujocoSpaceEngine::drive_motors;
        for (int step = 0; step < steps_; ++step)
            mj_step(model_.get(), data_.get());
        mjcb_control = nullptr;  // building another model makes trial steps
    }

private:
    static void drive_motors(const mjModel*, mjData* data) {
        const MujocoSpaceEngine& engine = *driven_space_engine;
        for (std::size_t i = 0; i < engine.targets_.size(); ++i)
            data->ctrl[i] = wanted_rate(MotorMode::kPosition, engine.targets_[i],
                                        data->qpos[engine.coordinate_[i]]);
    }

    int steps_;
    MujocoModel model_;
    MujocoData data_;
    std::vector<int> coordinate_;  // of each swing's degree, in qpos
    std::vector<double> targets_;
};

struct SpaceEngineKind {
    std::string id;
    int mujoco_steps = 0;  // a tick; 0: our own physics
};

std::vector<SpaceEngineKind> space_engines() {
    constexpr int default_steps = 8;  // 2.1 ms; MuJoCo's default is 2 ms
    constexpr int fewest_steps = 3;   // its users seldom use steps over 5 ms
    return {{"cambrian"}, {"mujoco", default_steps}, {"mujoco-coarse", fewest_steps}};
}

}  // namespace

// ---- Runs: the two parts that are counted, never inlined so that a profiler can name them ----

[[gnu::noinline]] std::unique_ptr<SpaceEngine> build_scene(const SpaceEngineKind& kind,
                                                           const SpaceCreature& creature,
                                                           const Environment& environment) {
    if (kind.mujoco_steps == 0) return std::make_unique<OurSpaceEngine>(creature.plan, environment);
    return std::make_unique<MujocoSpaceEngine>(creature, environment, kind.mujoco_steps);
}

[[gnu::noinline]] void advance_scene(SpaceEngine& engine, const SpaceCreature& creature,
                                     std::size_t ticks) {
    for (std::size_t tick = 0; tick < ticks; ++tick)
        engine.advance_tick(creature, tick);
}

namespace {

// Returns the CPU time of one simulated second, in microseconds, as the mean of the creatures.
double time_engine(const CellOptions& options, const SpaceEngineKind& kind,
                   const std::vector<SpaceCreature>& creatures, const Environment& environment) {
    double seconds = 0.0;
    for (const SpaceCreature& creature : creatures) {
        const auto engine = build_scene(kind, creature, environment);
        const double start = thread_cpu_time();
        advance_scene(*engine, creature, options.ticks());
        seconds += thread_cpu_time() - start;
    }
    constexpr double micro = 1e6;
    return micro * seconds / (static_cast<double>(creatures.size()) * options.seconds);
}

void compare_cell(const CellOptions& options, const SpaceWorkload& workload, std::size_t bodies) {
    std::vector<SpaceCreature> creatures;
    for (std::size_t i = 0; i < options.creatures; ++i)
        creatures.push_back(random_space_creature(bodies, options.seed + i));
    const std::vector<SpaceEngineKind> engines = select_kinds(space_engines(), options.engines);
    std::vector<std::vector<double>> micros(engines.size()), ratios(engines.size());
    for (std::size_t round = 0; round < (options.advance_only ? 1 : options.rounds); ++round) {
        for (std::size_t e = 0; e < engines.size(); ++e) {
            micros[e].push_back(time_engine(options, engines[e], creatures, workload.environment));
            ratios[e].push_back(micros[e].back() / micros[0].back());
        }
    }
    for (std::size_t e = 0; !options.advance_only && e < engines.size(); ++e)
        std::printf("%-8s %6zu  %-14s %10.1f %7.2f\n", workload.id.c_str(), bodies,
                    engines[e].id.c_str(), median(micros[e]), median(ratios[e]));
    std::fflush(stdout);
}

void compare_all(const CellOptions& options) {
    if (!options.advance_only)
        std::printf("%-8s %6s  %-14s %10s %7s\n", "workload", "bodies", "engine", "us/s", "ratio");
    for (const SpaceWorkload& workload : select_kinds(space_workloads(), options.workloads)) {
        for (const std::size_t bodies : options.bodies)
            compare_cell(options, workload, bodies);
    }
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) try {
    cambrian::bench::CellOptions options;
    CLI::App app("Times the same creatures in Cambrian's physics of space and in MuJoCo");
    cambrian::bench::add_cell_options(app, options, "cambrian, mujoco, mujoco-coarse");
    CLI11_PARSE(app, argc, argv);
    cambrian::bench::compare_all(options);
    return EXIT_SUCCESS;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
}
