#include "app/trial/motion_trace.h"

#include "core/text/number_text.h"
#include "evolution/evaluation/trials.h"
#include "simulator/trial.h"

#include <fmt/core.h>

#include <memory>
#include <string>

namespace cambrian {
namespace {

constexpr std::size_t kPiece = 65536;  // bytes per write

std::string heading(const Trial& trial, const Kinds& kinds) {
    const bool in_space = kinds.scene.dimensions == 3;
    std::string line = in_space ? "time,mass_x,mass_y,mass_z" : "time,mass_x,mass_y";
    for (std::size_t part = 0; part < trial.scene().part_count(); ++part) {
        const std::string name = fmt::format(",part{}", part);
        if (in_space) {
            for (const char* quantity :
                 {"_x", "_y", "_z", "_qw", "_qx", "_qy", "_qz", "_joint", "_joint2", "_joint3"})
                line.append(name).append(quantity);
            continue;
        }
        for (const char* quantity : {"_x", "_y", "_angle", "_joint"})
            line.append(name).append(quantity);
    }
    const std::vector<GrownOrgan>& organs = trial.phenotype().organs;
    std::size_t before = 0;  // organs on the same part so far
    for (std::size_t i = 0; i < organs.size(); ++i) {
        before = i > 0 && organs[i - 1].part == organs[i].part ? before + 1 : 0;
        line += fmt::format(",part{}_organ{}_{}", organs[i].part, before,
                            kinds.organs[organs[i].kind].id);
    }
    for (const GrownOrgan& organ : organs) {
        if (organ.deforms) line += fmt::format(",part{}_stretch", organ.part);
    }
    if (trial.surroundings().scent_field() != nullptr) line += ",scent";
    if (trial.surroundings().source().is_on()) line += ",light_x,light_y";
    return line + "\n";
}

// The attitude is a quaternion; degrees of freedom that a joint has not are 0.
template <class Cell>
void add_solid(const PhysicsScene& scene, std::size_t part, Cell&& cell) {
    const Pose pose = scene.part_pose(part);
    const Rotation& turn = pose.orientation;
    for (const double number : {pose.position.x(), pose.position.y(), pose.position.z(), turn.w(),
                                turn.x(), turn.y(), turn.z()})
        cell(number);
    for (std::uint8_t degree = 0; degree < kMostDegrees; ++degree)
        cell(scene.joint_coordinate(JointDegree{static_cast<std::uint16_t>(part), degree}));
}

// Adds a row with the present state.
void add_row(std::string& text, const Trial& trial) {
    const PhysicsScene& scene = trial.scene();
    const auto cell = [&text](double number) { text += "," + short_text(number); };
    text += short_text(trial.time());
    const Vec3 center = scene.center_of_mass();
    cell(center.x());
    cell(center.y());
    const bool in_space = trial.world().environment.dimensions == 3;
    if (in_space) cell(center.z());
    for (std::size_t part = 0; part < scene.part_count(); ++part) {
        if (in_space) {
            add_solid(scene, part, cell);
            continue;
        }
        const Pose pose = scene.part_pose(part);
        cell(pose.position.x());
        cell(pose.position.y());
        cell(planar_angle(pose));
        cell(scene.joint_coordinate(part));
    }
    // The signals of organs, the stretches of parts, all the scent in the world, and its light.
    const std::size_t effectors = trial.phenotype().effectors.size();
    for (std::size_t i = 0; i < trial.phenotype().organs.size(); ++i)
        cell(trial.creature().brain().output(effectors + i));
    for (const GrownOrgan& organ : trial.phenotype().organs) {
        if (organ.deforms) cell(scene.stretch(organ.part));
    }
    if (const ScentField* field = trial.surroundings().scent_field()) cell(field->total());
    if (const LightSource& light = trial.surroundings().source(); light.is_on()) {
        cell(light.place().x());
        cell(light.place().y());
    }
    text += '\n';
}

}  // namespace

Status write_motion_trace(OutputStream& output, const TrialSetup& setup,
                          const ExpressionSettings& expression, const Kinds& kinds,
                          const TrialWatch& watch) {
    auto phenotype = std::make_shared<const Phenotype>(
        express(*setup.genome, kinds, expression, setup.world.scene));
    auto started = Trial::start(std::move(phenotype), kinds, setup.world);
    if (!started) return started.error();
    Trial& trial = **started;
    while (trial.settling() && trial.tick()) {
    }
    std::string text = heading(trial, kinds);
    add_row(text, trial);
    for (bool more = !trial.finished(); more;) {
        if (watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
        more = trial.tick();
        add_row(text, trial);
        watch.note(trial.time());
        if (text.size() < kPiece) continue;
        if (Status written = output.write(text); !written) return written;
        text.clear();
    }
    return output.write(text);
}

}  // namespace cambrian
