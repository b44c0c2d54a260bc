// The engine of a page on which a creature lives, as WebAssembly. It reads a creature file, runs
// its trial tick by tick, computes its score again and evolves populations. assets/page/engine.js
// calls it. Texts that it takes are in a room that the caller fills; those that it returns end with
// a zero and stay until the next call.

#include "app/builtin_kinds.h"
#include "app/engine/shared_trials.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "evolution/fields/setting_field.h"
#include "evolution/individual/judged_individual.h"
#include "evolution/individual/population_digest.h"
#include "evolution/settings/goal_defaults.h"
#include "persist/creature/creature_file.h"
#include "persist/page/described_creature.h"
#include "persist/text/digest_text.h"
#include "persist/text/quoted_text.h"
#include "persist/text/setting_value.h"
#include "simulator/simulator_version.h"
#include "simulator/tick_checks.h"
#include "simulator/trial.h"
#include "simulator/trial_watch.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#define CAMBRIAN_EXPORT(name) extern "C" __attribute__((export_name(#name)))

using namespace cambrian;

namespace {

// The spring of a pulled part, per kg of creature, as in the studio (studio/playback/replay.cpp).
constexpr double kHoldStiffness = 60.0;  // N/m
constexpr double kHoldDamping = 6.0;     // N s/m

// Numbers of a moment, as engine.js reads them.
constexpr std::size_t kHeadNumbers = 11;
constexpr std::size_t kPartNumbers = 12;

struct Hold {
    std::size_t part = 0;
    Vec3 grip = Vec3::Zero();    // in the part's frame, m
    Vec3 target = Vec3::Zero();  // m
};

struct Life {
    std::optional<EvolutionKinds> kinds;
    std::optional<CreatureDocument> document;
    std::shared_ptr<const Phenotype> phenotype;
    std::unique_ptr<Trial> trial;
    Environment environment;
    bool disturbed = false;
    std::optional<Hold> hold;
    std::vector<double> moment;
};

struct Run {
    std::optional<EvolutionKinds> kinds;
    ExperimentSettings settings;
    std::unique_ptr<Evolution> evolution;
    std::unique_ptr<SharedTrials> trials;
};

struct Engine {
    std::string text;
    Life life;
    Run run;
};

Engine& engine() {
    static Engine the;
    return the;
}

const char* say(std::string text) {
    engine().text = std::move(text);
    return engine().text.c_str();
}

double* put(double* at, const Vec3& v) {
    for (int i = 0; i < 3; ++i)
        *at++ = v[i];
    return at;
}

void note_moment() {
    Life& life = engine().life;
    const Trial& trial = *life.trial;
    const PhysicsScene& scene = trial.scene();
    const LightSource& light = trial.surroundings().source();
    double* at = put(life.moment.data(), scene.center_of_mass());
    *at++ = trial.time();
    *at++ = trial.settling() ? 1.0 : trial.finished() ? 2.0 : 0.0;
    *at++ = static_cast<double>(trial.ticks());
    *at++ = light.is_on() ? 1.0 : 0.0;
    at = put(at, light.place());
    *at++ = trial.wall() != nullptr ? trial.wall()->center.x() : 0.0;
    for (std::size_t i = 0; i < life.phenotype->parts.size(); ++i) {
        const Pose pose = scene.part_pose(i);
        at = put(at, pose.position);
        *at++ = pose.orientation.w();
        at = put(at, pose.orientation.vec());
        at = put(at, scene.part_half_extents(i));
        int touched = 0;
        for (std::size_t face = 0; face < kFaceCount; ++face)
            if (scene.face_touched(i, static_cast<Face>(face))) touched |= 1 << face;
        *at++ = touched;
        *at++ = scene.joint_effort(i);
    }
}

void pull() {
    const Life& life = engine().life;
    PhysicsScene& scene = life.trial->scene();
    const Pose pose = scene.part_pose(life.hold->part);
    const Twist twist = scene.part_twist(life.hold->part);
    const Vec3 arm = pose.orientation * life.hold->grip;
    const Vec3 velocity = twist.linear + twist.angular.cross(arm);
    const Vec3 stretch = life.hold->target - (pose.position + arm);
    scene.pull(life.hold->part, life.hold->grip,
               scene.mass() * (kHoldStiffness * stretch - kHoldDamping * velocity));
}

// Takes one line KEY=VALUE of settings. Returns an error, or an empty text.
std::string take_setting(std::string_view line, ExperimentSettings& settings,
                         const EvolutionKinds& kinds) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos)
        return fmt::format("{}: expected KEY=VALUE", quoted_text(line));
    const std::string_view key = line.substr(0, equals);
    const std::string value(line.substr(equals + 1));
    for (const SettingField& field : setting_fields(kinds)) {
        if (path_of(field) != key) continue;
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        SettingValue given = value;
        if (value == "true" || value == "false")
            given = value == "true";
        else if (!value.empty() && *end == '\0' && value.find_first_of(".eE") == std::string::npos)
            given = static_cast<std::int64_t>(number);
        else if (!value.empty() && *end == '\0')
            given = number;
        const SettingCheck check = assign(field, given, settings);
        return check.fault == SettingFault::kNone ? "" : fmt::format("{}: {}", key, check.message);
    }
    return fmt::format("{}: no setting of this engine", quoted_text(key));
}

}  // namespace

// Returns a room for a text of so many bytes.
CAMBRIAN_EXPORT(engine_room) char* engine_room(std::size_t bytes) {
    engine().text.assign(bytes, ' ');
    return engine().text.data();
}

// Returns the version of the simulator for so many dimensions.
CAMBRIAN_EXPORT(engine_version) const char* engine_version(int dimensions) {
    return say(std::string(simulator_version(dimensions)));
}

// Reads the creature file in the room. Returns an error, or an empty text.
CAMBRIAN_EXPORT(engine_read) const char* engine_read() {
    const std::string file = std::move(engine().text);
    Life& life = engine().life;
    life = {};
    life.kinds = builtin_kinds(dimensions_of_creature(file));
    auto document = parse_creature(file, "the creature", *life.kinds);
    if (!document) return say(document.error().message);
    life.document = std::move(*document);
    const ExperimentSettings& settings = life.document->settings();
    life.phenotype = std::make_shared<const Phenotype>(express(
        life.document->genome(), life.kinds->creature, settings.expression, settings.world.scene));
    life.moment.assign(kHeadNumbers + kPartNumbers * life.phenotype->parts.size(), 0.0);
    return say("");
}

// Puts the creature at the start of its trial. Returns an error, or an empty text.
CAMBRIAN_EXPORT(engine_begin) const char* engine_begin() {
    Life& life = engine().life;
    auto trial = Trial::start(life.phenotype, life.kinds->creature,
                              first_trial_world(life.document->settings()));
    if (!trial) return say(trial.error().message);
    life.trial = std::move(*trial);
    life.environment = life.document->settings().world.environment;
    life.disturbed = false;
    life.hold.reset();
    note_moment();
    return say("");
}

// Returns the numbers of the present moment: centre of mass (3), time, phase (1 settling, 2 over),
// ticks, whether there is a light and its place (3), the x of the wall or 0 without one; then for
// each part its place (3), attitude (w, x, y, z), half extents (3), touched faces and effort.
CAMBRIAN_EXPORT(engine_moment) const double* engine_moment() {
    return engine().life.moment.data();
}

// Advances by a tick. Returns its check byte, or 256 if nothing moves any more.
CAMBRIAN_EXPORT(engine_tick) int engine_tick() {
    Life& life = engine().life;
    if (life.trial->scene().status() != SceneStatus::kRunning) return 256;
    if (life.hold) {
        pull();
        life.disturbed = true;
    }
    life.trial->tick();
    note_moment();
    TickChecks check;
    note_tick(check, *life.trial);
    return check.empty() ? 256 : check.front();
}

// Returns whether somebody has changed the motion.
CAMBRIAN_EXPORT(engine_disturbed) int engine_disturbed() {
    return engine().life.disturbed ? 1 : 0;
}

// Takes hold of a part at a place of the world, or lets go of it if the part is negative.
CAMBRIAN_EXPORT(engine_hold) void engine_hold(int part, double x, double y, double z) {
    Life& life = engine().life;
    life.hold.reset();
    if (part < 0 || static_cast<std::size_t>(part) >= life.phenotype->parts.size()) return;
    const auto held = static_cast<std::size_t>(part);
    const Pose pose = life.trial->scene().part_pose(held);
    const Vec3 place(x, y, z);
    life.hold = Hold{.part = held,
                     .grip = pose.orientation.conjugate() * (place - pose.position),
                     .target = place};
}

CAMBRIAN_EXPORT(engine_drag) void engine_drag(double x, double y, double z) {
    if (engine().life.hold) engine().life.hold->target = Vec3(x, y, z);
}

// Changes gravity (m/s^2) and friction of the running trial.
CAMBRIAN_EXPORT(engine_world) void engine_world(double gravity, double friction) {
    Life& life = engine().life;
    if (life.environment.gravity == gravity && life.environment.friction == friction) return;
    life.environment.gravity = gravity;
    life.environment.friction = friction;
    life.trial->set_environment(life.environment);
    life.disturbed = true;
}

// Computes the scored trials again, as `cambrian verify` does, and every tick of the first one.
CAMBRIAN_EXPORT(engine_verify) const char* engine_verify() {
    const Life& life = engine().life;
    const CreatureDocument& document = *life.document;
    if (!document.scored()) return say(R"({"scored":false})");
    const ExperimentSettings& settings = document.settings();
    const EvaluationRequest request{.genome = document.creature.individual->genome,
                                    .trial_seed = trial_seed(settings)};
    const EvaluationResult result = evaluate_in_trials(request, settings, *life.kinds);
    TickChecks ticks;
    auto trial = Trial::start(life.phenotype, life.kinds->creature, first_trial_world(settings));
    if (trial) run_noting_ticks(**trial, ticks, [] { return false; });
    const TickChecks& recorded = document.notes.ticks;
    const auto different = first_different_tick(ticks, recorded);
    return say(fmt::format(
        R"({{"scored":true,"same":{},"digest":"{}","recorded":"{}","score":{},"unit":{},"ticks":{},"recordedTicks":{},"differentTick":{},"simulator":{}}})",
        result.digest == document.result().digest && unconfirmed_score(result) == document.score(),
        digest_text(result.digest), digest_text(document.result().digest),
        unconfirmed_score(result), quoted_text(document.notes.unit), ticks.size(), recorded.size(),
        different && !recorded.empty() ? *different : 0, quoted_text(document.notes.simulator)));
}

// Returns what the page must know to draw.
CAMBRIAN_EXPORT(engine_describe) const char* engine_describe() {
    const Life& life = engine().life;
    return say(described_creature(*life.document, *life.phenotype, *life.kinds));
}

// Takes the settings of an evolution: lines KEY=VALUE, as `cambrian evolve --set` takes them, the
// first ones [environment] dimensions and the goal, whose defaults the others change. Returns an
// error, or an empty text.
CAMBRIAN_EXPORT(engine_settings) const char* engine_settings() {
    const std::string lines = std::move(engine().text);
    Run& run = engine().run;
    run = {};
    std::vector<std::string_view> given;
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size());
        if (end > at) given.push_back(std::string_view(lines).substr(at, end - at));
        at = end + 1;
    }
    const auto says = [&](std::string_view line) {
        return std::find(given.begin(), given.end(), line) != given.end();
    };
    const bool in_space = says("environment.dimensions=3");
    run.kinds = builtin_kinds(in_space ? 3 : 2);
    if (in_space) adopt_space_defaults(run.settings, run.kinds->goals);
    for (const std::string_view line : given) {
        if (!line.starts_with("goal.behavior=")) continue;
        const GoalKind* goal = run.kinds->goals.find(line.substr(line.find('=') + 1));
        if (goal == nullptr)
            return say(fmt::format("{}: no goal of this engine", quoted_text(line)));
        run.settings.goal = goal->id;
        adopt_defaults(run.settings, *goal);
        if (in_space) adopt_space(run.settings.world);
    }
    for (const std::string_view line : given)
        if (std::string error = take_setting(line, run.settings, *run.kinds); !error.empty())
            return say(std::move(error));
    if (const Status checked = check_settings(run.settings, *run.kinds); !checked)
        return say(checked.error().message);
    run.evolution = std::make_unique<Evolution>(
        std::make_shared<const ExperimentSettings>(run.settings), *run.kinds);
    run.trials = std::make_unique<SharedTrials>(*run.kinds);
    return say("");
}

// Goes on with the generation as far as results allow. Returns the number of trials whose results
// it needs then, or 0 if the generation is evaluated.
CAMBRIAN_EXPORT(engine_needs) int engine_needs() {
    Run& run = engine().run;
    EvaluationProgress progress;
    if (run.evolution->evaluate(*run.trials, progress, {})) return 0;
    return static_cast<int>(run.trials->count());
}

// Runs one of these trials. Returns its result, for engine_take() of others.
CAMBRIAN_EXPORT(engine_run) const char* engine_run(int index) {
    return say(engine().run.trials->run(static_cast<std::size_t>(index)));
}

// Takes the result in the room of a trial that another engine ran. Returns an error, or an empty
// text.
CAMBRIAN_EXPORT(engine_take) const char* engine_take(int index) {
    const std::string result = std::move(engine().text);
    const Status taken = engine().run.trials->take(static_cast<std::size_t>(index), result);
    return say(taken ? "" : taken.error().message);
}

// Tells about an evaluated generation in a line of JSON, which the file of its best creature
// follows, and breeds the next.
CAMBRIAN_EXPORT(engine_generation) const char* engine_generation() {
    Run& run = engine().run;
    const std::vector<IndividualPtr>& population = run.evolution->population();
    const GenerationStatistics& now = run.evolution->history().back();
    const JudgedIndividual best{run.evolution->generation(), population.front(),
                                run.evolution->shared_settings()};
    std::string text =
        fmt::format(R"({{"generation":{},"best":{},"median":{},"digest":"{}","trials":{}}})",
                    run.evolution->generation(), population.front()->result.fitness, now.median,
                    digest_text(population_digest(population)), now.evaluations);
    text += '\n';
    text += write_creature(creature_document(best, *run.kinds), *run.kinds);
    run.evolution->breed();
    return say(std::move(text));
}
