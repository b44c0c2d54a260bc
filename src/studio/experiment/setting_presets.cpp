#include "studio/experiment/setting_presets.h"

#include "evolution/settings/goal_defaults.h"
#include "studio/experiment/settings_editor.h"
#include "world/environment.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

using Settings = ExperimentSettings;

// Sets the medium and ground but keeps the density of bodies and the light. `medium` is that of the
// plane.
void change_world(Settings& settings, Environment medium) {
    Environment& world = settings.world.environment;
    if (world.dimensions == 3) {
        TrialWorld space;
        space.environment = medium;
        adopt_space(space);
        medium = space.environment;
    }
    world.gravity = medium.gravity;
    world.gravity_direction = medium.gravity_direction;
    world.has_ground = medium.has_ground;
    world.terrain = medium.terrain;
    world.friction = medium.friction;
    world.elasticity = medium.elasticity;
    world.viscosity_linear = medium.viscosity_linear;
    world.viscosity_quadratic = medium.viscosity_quadratic;
}

void go_on_land(Settings& settings, double gravity, double friction) {
    Environment world;
    world.gravity = gravity;
    world.friction = friction;
    change_world(settings, world);
}

// On the Earth, but for the shape of the ground.
void go_over(Settings& settings, const TerrainSettings& terrain) {
    Environment world;
    world.terrain = terrain;
    change_world(settings, world);
}

void go_in_fluid(Settings& settings, double linear, double quadratic) {
    Environment world;
    world.gravity = 0.0;
    world.has_ground = false;
    world.viscosity_linear = linear;
    world.viscosity_quadratic = quadratic;
    change_world(settings, world);
}

void go_in_air(Settings& settings) {
    Environment world;
    world.gravity = 0.25;
    world.has_ground = false;
    world.viscosity_linear = 0.02;
    world.viscosity_quadratic = 0.2;
    change_world(settings, world);
}

// Sets the default mutation weights, divided by one divisor for the body's operators and one for
// the brain's.
void weigh_mutations(Settings& settings, const EvolutionKinds& kinds, double body_divisor,
                     double brain_divisor) {
    for (const MutationKind& kind : kinds.mutations.all()) {
        const bool is_body = kind.subject == MutationSubject::kBody;
        settings.mutation.weights[kind.id] =
            kind.default_weight / (is_body ? body_divisor : brain_divisor);
    }
}

void grow_reflexes(Settings& settings, const EvolutionKinds& kinds) {
    weigh_mutations(settings, kinds, 1.0, 1.0);
    settings.mutation.weights["add-reflex"] = 25.0;
}

void try_creatures(Settings& settings, int trials, double friction_jitter, double tilt_jitter) {
    TrialSettings& trial = settings.world.trial;
    trial.trials = trials;
    trial.friction_jitter = friction_jitter;
    trial.tilt_jitter = tilt_jitter;
    trial.combine = TrialSettings{}.combine;
}

// Sets the range of sizes of random parts, in m.
void size_founders(Settings& settings, const FounderSettings& sizes) {
    settings.founders.min_length = sizes.min_length;
    settings.founders.max_length = sizes.max_length;
    settings.founders.min_width = sizes.min_width;
    settings.founders.max_width = sizes.max_width;
}

// Thick parts have strong joints for their weight, as jumping creatures need.
FounderSettings big_founders() {
    FounderSettings sizes;
    sizes.min_length = 0.4;
    sizes.max_length = 1.6;
    sizes.min_width = 0.2;
    sizes.max_width = 0.96;
    return sizes;
}

void move_joints(Settings& settings, double speed_limit) {
    settings.world.scene.motor_speed_limit = speed_limit;
}

void allow_sensors(Settings& settings, const EvolutionKinds& kinds,
                   bool (*wanted)(const SensorKind& sensor)) {
    for (const SensorKind& sensor : kinds.creature.sensors.all()) {
        for (const SensorChannel& channel : sensor.channels)
            settings.founders.channels[channel.id] = wanted(sensor);
    }
}

constexpr double kMoonGravity = 1.62;

constexpr std::string_view kEnvironment = "environment";
constexpr std::string_view kMutation = "mutation";
constexpr std::string_view kSimulation = "simulation";
constexpr std::string_view kTrial = "trial";
constexpr std::string_view kBody = "body";
constexpr std::string_view kSensors = "body.sensors";

// Mutations: breeding/README.md 4; trials: simulator/README.md 1.
constexpr std::array kPresets = {
    SettingPreset{kEnvironment, "Earth", "Solid ground under full weight.",
                  [](Settings& s, const EvolutionKinds&) { go_on_land(s, kEarthGravity, 0.8); }},
    SettingPreset{kEnvironment, "Rough ground", "The Earth with bumps as high as a foot.",
                  [](Settings& s, const EvolutionKinds&) {
                      go_over(s, {.kind = "rough", .height = 0.12, .spacing = 0.5});
                  },
                  true},
    SettingPreset{kEnvironment, "Hills", "The Earth with gentle hills, at most 15 degrees steep.",
                  [](Settings& s, const EvolutionKinds&) {
                      go_over(s, {.kind = "hills", .height = 0.33, .spacing = 2.5});
                  },
                  true},
    SettingPreset{kEnvironment, "Stairs", "The Earth with stairs that rise to both sides.",
                  [](Settings& s, const EvolutionKinds&) {
                      go_over(s, {.kind = "stairs", .height = 0.12, .spacing = 0.6});
                  },
                  true},
    SettingPreset{kEnvironment, "Obstacle course",
                  "The Earth with hurdles, steps, gaps and ramps, each higher than the last.",
                  [](Settings& s, const EvolutionKinds&) {
                      go_over(s, {.kind = "course", .height = 0.3, .gap = 0.6, .same = false});
                  },
                  true},
    SettingPreset{kEnvironment, "Moon", "A sixth of the weight.",
                  [](Settings& s, const EvolutionKinds&) { go_on_land(s, kMoonGravity, 0.8); }},
    SettingPreset{kEnvironment, "Ice", "Full weight with hardly any friction.",
                  [](Settings& s, const EvolutionKinds&) { go_on_land(s, kEarthGravity, 0.05); }},
    SettingPreset{kEnvironment, "Water",
                  "Weightless; drag grows with the square of the speed, as for swimmers.",
                  [](Settings& s, const EvolutionKinds&) { go_in_fluid(s, 0.2, 1.0); }},
    SettingPreset{kEnvironment, "Treacle", "Weightless; drag grows with the speed, nothing glides.",
                  [](Settings& s, const EvolutionKinds&) { go_in_fluid(s, 8.0, 0.0); }},
    SettingPreset{kEnvironment, "Air", "Weak gravity in a medium thin enough to fly in.",
                  [](Settings& s, const EvolutionKinds&) { go_in_air(s); }},
    SettingPreset{kEnvironment, "Thin water", "Water with a tenth of its drag.",
                  [](Settings& s, const EvolutionKinds&) { go_in_fluid(s, 0.02, 0.1); }},
    SettingPreset{kEnvironment, "Zero-g tank", "Weightless in a thin medium.",
                  [](Settings& s, const EvolutionKinds&) { go_in_fluid(s, 0.2, 0.1); }},
    SettingPreset{
        kMutation, "Body and brain", "The default weights of all kinds of mutations.",
        [](Settings& s, const EvolutionKinds& kinds) { weigh_mutations(s, kinds, 1.0, 1.0); }},
    SettingPreset{
        kMutation, "Tune the brain", "Bodies change a fifth as often, so that control is refined.",
        [](Settings& s, const EvolutionKinds& kinds) { weigh_mutations(s, kinds, 5.0, 1.0); }},
    SettingPreset{
        kMutation, "Reshape", "Brains change a third as often, so that new bodies are found.",
        [](Settings& s, const EvolutionKinds& kinds) { weigh_mutations(s, kinds, 1.0, 3.0); }},
    SettingPreset{kMutation, "Grow reflexes",
                  "Many children get a sensor that turns a joint further or less far, so that "
                  "swimmers learn to steer.",
                  [](Settings& s, const EvolutionKinds& kinds) { grow_reflexes(s, kinds); }},
    SettingPreset{kSimulation, "Usual muscles", "Muscles move joints at up to 6 rad/s.",
                  [](Settings& s, const EvolutionKinds&) {
                      move_joints(s, SceneSettings{}.motor_speed_limit);
                  }},
    SettingPreset{kSimulation, "Quick muscles",
                  "Muscles move joints at up to 20 rad/s, with which creatures jump a metre high.",
                  [](Settings& s, const EvolutionKinds&) { move_joints(s, 20.0); }},
    SettingPreset{kTrial, "One trial", "One trial, without jitter.",
                  [](Settings& s, const EvolutionKinds&) { try_creatures(s, 1, 0.0, 0.0); }},
    SettingPreset{kTrial, "Robust",
                  "The mean of three trials, two of them with a friction jitter of 15 % and a tilt "
                  "jitter of 2 degrees.",
                  [](Settings& s, const EvolutionKinds&) { try_creatures(s, 3, 0.15, 2.0); }},
    SettingPreset{kBody, "Usual founders", "Random creatures of parts of all sizes.",
                  [](Settings& s, const EvolutionKinds&) { size_founders(s, {}); }},
    SettingPreset{kBody, "Big founders",
                  "Random creatures of long and thick parts, which are strong, as jumping needs.",
                  [](Settings& s, const EvolutionKinds&) { size_founders(s, big_founders()); }},
    SettingPreset{kSensors, "Blind",
                  "Joint and contact sensors, which tell nothing of what is far away.",
                  [](Settings& s, const EvolutionKinds& kinds) {
                      allow_sensors(s, kinds, [](const SensorKind& each) { return each.usual; });
                  }},
    SettingPreset{kSensors, "Sims 1994", "Joint, contact and light sensors, as Sims had in 1994.",
                  [](Settings& s, const EvolutionKinds& kinds) {
                      allow_sensors(s, kinds, [](const SensorKind& each) {
                          return each.usual || each.id == "light";
                      });
                  }},
    SettingPreset{kSensors, "Feelers",
                  "Whiskers and heights of the ground and no others, among which selection would "
                  "hardly find them.",
                  [](Settings& s, const EvolutionKinds& kinds) {
                      allow_sensors(s, kinds,
                                    [](const SensorKind& each) { return each.feels_ground; });
                  },
                  true},
    SettingPreset{kSensors, "All senses", "All kinds of sensors.",
                  [](Settings& s, const EvolutionKinds& kinds) {
                      allow_sensors(s, kinds, [](const SensorKind&) { return true; });
                  }},
};

}  // namespace

std::span<const SettingPreset> setting_presets() {
    return kPresets;
}

std::span<const SettingPreset> setting_presets(std::string_view table) {
    const auto of_table = [table](const SettingPreset& preset) { return preset.table == table; };
    const auto first = std::find_if(kPresets.begin(), kPresets.end(), of_table);
    return {first, std::find_if_not(first, kPresets.end(), of_table)};
}

bool is_in_force(const SettingPreset& preset, const ExperimentSettings& settings,
                 const EvolutionKinds& kinds, const std::vector<SettingField>& fields) {
    Settings before = settings;
    Settings after = settings;
    preset.apply(after, kinds);
    return std::all_of(fields.begin(), fields.end(), [&](const SettingField& field) {
        return !field.table.starts_with(preset.table) || same_value(field, before, after);
    });
}

}  // namespace cambrian
