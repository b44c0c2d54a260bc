#include "evolution/fields/setting_field.h"

#include "core/text/number_text.h"
#include "evolution/fields/setting_table.h"
#include "evolution/selections/survival.h"
#include "evolution/settings/trial_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace cambrian {
namespace {

constexpr double kShareSlack = 0.01;  // tolerance of a sum of shares, for rounded thirds

using setting_table::Range;
using setting_table::Settings;
using setting_table::TableBuilder;

void add_run(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder run(fields, "run");
    run.number(&Settings::seed, "seed", "Seed", "", Range{0, 1e15},
               "The seed of all random numbers. The same seed gives the same evolution.")
        .live = false;
    run.number(&Settings::generations, "generations", "Generations", "", Range{1, 1e6},
               "The number of generations after which an unattended run stops.");
    run.number(
        &Settings::max_evaluations, "max-evaluations", "Evaluations", "", Range{1, 1e9},
        "The number of trials after which an unattended run stops, at the end of a generation.");
    run.number(&Settings::target_fitness, "target-fitness", "Target fitness", "", Range{0, 1e6},
               "The best fitness at which an unattended run stops. 0 means no target.");
    run.flag(&Settings::terminate_early, "stop-hopeless", "Early termination",
             "A trial ends as soon as the creature could not survive even at 1.5 times its best "
             "speed. The first 30 such trials and 10 % of the later ones run to their end, to "
             "check the rule. It has an effect with one trial a creature, in walking, swimming and "
             "jumping, where the best share survives.")
        .applies = [&kinds](const Settings& s) {
        const GoalKind* goal = kinds.goals.find(s.goal);
        const SelectionKind* selection = kinds.selections.find(s.selection.method);
        return goal != nullptr && goal->may_give_up && selection != nullptr &&
               may_terminate_early(*selection, s);
    };
}

void add_simulation(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder table(fields, "simulation");
    table.kind_choice(&SceneSettings::integrator, "integrator", "Integrator",
                      kinds.creature.scene.integrators,
                      "The numerical method that computes motion from forces.");
    table
        .number(&SceneSettings::tolerance, "tolerance", "Tolerance", "", Range{1e-8, 1e-1},
                "The permitted error of a time step. A smaller tolerance is more exact and slower.")
        .logarithmic = true;
    table
        .number(&SceneSettings::contact_step, "contact-step", "Contact step", "s",
                Range{kLeastContactStep, 1.0 / 60},
                "The longest time step while parts are in contact or joints are at their limits.")
        .logarithmic = true;
    table
        .number(&SceneSettings::max_evaluations, "max-evaluations", "Work limit", "evaluations/s",
                Range{1e3, kMostEvaluations},
                "The largest number of evaluations of the accelerations for each simulated second. "
                "A trial that needs more is stopped.")
        .logarithmic = true;
    table.number(
        &SceneSettings::muscle_strength, "muscle-strength", "Muscle strength", "N/m", Range{0, 1e4},
        "The largest torque of a joint, divided by the square of its narrower part's width.");
    table.number(&SceneSettings::target_smoothing, "target-smoothing", "Muscle smoothing", "s",
                 Range{0, 10},
                 "The time constant with which a joint follows its brain. A longer time gives "
                 "calmer motion.");
    table.number(&SceneSettings::motor_speed_limit, "motor-speed-limit", "Joint speed limit",
                 "rad/s", Range{0, 100}, "The largest speed that a muscle asks of its joint.");
    table
        .number(&SceneSettings::deform_speed_limit, "deform-speed-limit", "Deformer speed limit",
                "1/s", Range{0, 100},
                "The largest rate at which a deformer asks its part to stretch or to shorten.")
        .later = true;
    table.number(&SceneSettings::motor_frequency, "motor-frequency", "Muscle frequency", "rad/s",
                 Range{0.1, 200},
                 "The frequency with which a muscle corrects a joint that is off its target.");
    table
        .choice(&SceneSettings::motor_mode, "motor-mode", "Control mode",
                {kMotorModeIds.begin(), kMotorModeIds.end()},
                "The quantity of a joint that a brain sets: its position, its speed or its torque.")
        .live = false;
    table.number(&SceneSettings::brain_steps, "brain-steps", "Brain steps per tick", "",
                 Range{1, 2}, "The number of steps of the brain in each sixtieth of a second.");
}

void add_trial(std::vector<SettingField>& fields) {
    TableBuilder table(fields, "trial");
    table.number(&TrialSettings::duration, "duration", "Duration", "s", Range{0, 1e4},
                 "The time during which a creature is judged.");
    table.number(
        &TrialSettings::settle_limit, "settle-limit", "Settling", "s", Range{0, 60},
        "The longest time in which a creature may come to rest on the ground before it is judged.");
    table.flag(&TrialSettings::settle_motors_off, "limp-settle", "Settle with motors off",
               "Creatures come to rest with motors off and without friction. Otherwise they hold "
               "their rest pose.");
    table.number(&TrialSettings::max_part_speed, "max-part-speed", "Speed limit", "m/s",
                 Range{1, 1e4},
                 "The speed limit of a part. A creature with a faster part is disqualified.");
    table.number(&TrialSettings::max_part_spin, "max-part-spin", "Angular speed limit", "rad/s",
                 Range{1, 1e4},
                 "The limit of angular speed of a part. A creature with a part that spins faster "
                 "is disqualified.");
    table.number(
        &TrialSettings::max_ground_depth, "max-ground-depth", "Penetration limit", "m",
        Range{1e-3, 10},
        "The limit of penetration of the ground. A creature that stays deeper is disqualified.");
    table.number(&TrialSettings::max_reversal_rate, "max-reversal-rate", "Joint reversal limit",
                 "Hz", Range{0.1, 1e3},
                 "The limit of the frequency at which joints change direction. A creature that "
                 "shakes faster has its score scaled down.");
    table.flag(&TrialSettings::stop_at_rest, "stop-at-rest", "Stop at rest",
               "A trial ends when body and brain of the creature have been at rest for 2 s, "
               "because its score is then known.");
    setting_table::add_trials(table);
}

void add_population(std::vector<SettingField>& fields) {
    TableBuilder table(fields, "population");
    table.number(&PopulationSettings::size, "size", "Population size", "creatures", Range{2, 20000},
                 "The number of creatures in a generation.");
    table.number(&PopulationSettings::immigrants, "immigrants", "Random immigrants", "creatures",
                 Range{0, 20000}, "The number of new random creatures in each generation.");
    table
        .number(&PopulationSettings::tuned, "tuned", "Tuned offspring", "", Range{0, 1},
                "The share of the offspring that copy the best creature of a lineage, with all or "
                "some of its numbers changed a little.")
        .later = true;
    setting_table::add_rhythmic_share(table);
    table
        .choice(&PopulationSettings::fill, "fill", "Fill up with", {"mutants", "random"},
                "The creatures that fill up the population if founders are given: mutants of the "
                "founders or random creatures.")
        .live = false;
    table
        .number(&PopulationSettings::museum, "museum", "From the museum", "", Range{0, 1},
                "The share of the founders that come from the museum of champions. Random "
                "creatures take the other places, and in each generation one of the founders joins "
                "again. 0 begins from nothing.")
        .live = false;
}

void add_breeding(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder breeding(fields, "breeding");
    breeding.choice(&BreedingSettings::choice, "choice", "Choice of method",
                    {"shares", "attribute"},
                    "The breeding method of an offspring follows from the shares below, or from an "
                    "attribute of its parent that is inherited and mutates.");
    for (const BreedingKind& kind : kinds.breeding.all()) {
        breeding.number(
            [ id = kind.id, standard = kind.default_share ](Settings & s) -> auto& {
                return s.breeding.shares.try_emplace(id, standard).first->second;
            },
            kind.id, kind.label, "", Range{0, 1},
            "The share of the offspring that this method makes. The shares of all methods add up "
            "to 1.");
    }
}

void add_mutation(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder mutation(fields, "mutation");
    mutation.choice(&MutationSettings::scheme, "scheme", "Scheme", {"count-first", "gate", "none"},
                    "The rule by which the number of mutations of an offspring is drawn.");
    mutation.number(&MutationSettings::rate, "rate", "Mutation rate", "x", Range{0, 8},
                    "The factor by which the number of mutations of an offspring is scaled. At 1, "
                    "25 % of the offspring have none, 50 % have one and 25 % have more.");
    mutation.flag(&MutationSettings::remove_disconnected_neurons, "collect-mute-neurons",
                  "Prune neurons",
                  "Neurons without a path to a joint or an organ are removed. Otherwise they stay "
                  "and may be connected later.");
    TableBuilder weights(fields, "mutation.weights");
    for (const MutationKind& kind : kinds.mutations.all()) {
        weights
            .number(
                [ id = kind.id, standard = kind.default_weight ](Settings & s) -> auto& {
                    return s.mutation.weights.try_emplace(id, standard).first->second;
                },
                kind.id, kind.label, "", Range{0, 1000},
                "The frequency of this kind of mutation, relative to the others.")
            .later = kind.later;
    }
}

void add_body(std::vector<SettingField>& fields) {
    TableBuilder body(fields, "body");
    const auto structural = [&](auto&&... arguments) {
        body.number(std::forward<decltype(arguments)>(arguments)...).live = false;
    };
    structural(&ExpressionSettings::max_parts, "max-parts", "Parts at most", "", Range{2, 32},
               "The largest number of parts of a body.");
    structural(&ExpressionSettings::max_depth, "max-depth", "Depth at most", "", Range{1, 32},
               "The largest number of joints between the root and any part.");
    structural(&ExpressionSettings::max_neurons, "max-neurons", "Neurons at most", "",
               Range{1, 4096}, "The largest number of neurons of a brain.");
    body.flag(&ExpressionSettings::strict_overlap, "strict-overlap", "No overlap",
              "Bodies are rejected if parts overlap that no joint connects. Otherwise such parts "
              "pass through each other.")
        .live = false;
    structural(&FounderSettings::min_nodes, "min-nodes", "Founder nodes, least", "",
               Range{1, gene_range::kMaxNodes},
               "The smallest number of part genes of a random creature.");
    structural(&FounderSettings::max_nodes, "max-nodes", "Founder nodes, most", "",
               Range{1, gene_range::kMaxNodes},
               "The largest number of part genes of a random creature.");
    structural(&FounderSettings::min_length, "min-length", "Founder length, least", "m",
               Range{gene_range::kMinSize, gene_range::kMaxLength},
               "The smallest length of a random part.");
    structural(&FounderSettings::max_length, "max-length", "Founder length, most", "m",
               Range{gene_range::kMinSize, gene_range::kMaxLength},
               "The largest length of a random part.");
    structural(&FounderSettings::min_width, "min-width", "Founder width, least", "m",
               Range{gene_range::kMinSize, gene_range::kMaxWidth},
               "The smallest width of a random part.");
    structural(&FounderSettings::max_width, "max-width", "Founder width, most", "m",
               Range{gene_range::kMinSize, gene_range::kMaxWidth},
               "The largest width of a random part.");
    structural(&FounderSettings::moving_share, "moving-share", "Moving joints", "", Range{0, 1},
               "The share of a random creature's joints that move.");
    structural(&FounderSettings::symmetric_share, "symmetric-share", "Symmetry", "", Range{0, 1},
               "The share of a random creature's parts that grow as mirror pairs.");
    structural(&FounderSettings::max_recursion, "max-recursion", "Founder recursion", "",
               Range{1, gene_range::kMaxRecursion},
               "The largest number of repetitions of a random part along a limb.");
    structural(&FounderSettings::max_node_neurons, "node-neurons", "Founder neurons a part", "",
               Range{0, gene_range::kMaxNodeNeurons},
               "The largest number of neurons in each part of a random creature.");
    structural(&FounderSettings::max_brain_neurons, "brain-neurons", "Founder central neurons", "",
               Range{0, gene_range::kMaxBrainNeurons},
               "The largest number of central neurons of a random creature.");
}

std::string place(const SettingField& field) {
    return fmt::format("[{}] {}", field.table, field.key);
}

Status out_of_range(const SettingField& field, double value) {
    return Error{fmt::format("{}: {} {} [{}, {}]", place(field), short_text(value),
                             std::isfinite(value) ? "is outside" : "is not finite; expected",
                             short_text(field.low), short_text(field.high))};
}

Status check_order(double low, double high, const char* low_key, const char* high_key) {
    if (low <= high) return {};
    return Error{fmt::format("{}: {} is above {}, which is {}", low_key, short_text(low), high_key,
                             short_text(high))};
}

// Rejects settings that are in range one by one but contradict one another.
Status check_together(const Settings& s, const EvolutionKinds& kinds) {
    if (Status order = setting_table::check_founders(s); !order) return order;
    if (Status order = setting_table::check_distances(s); !order) return order;
    if (Status ground = setting_table::check_terrain(s); !ground) return ground;
    if (Status goal = setting_table::check_goal(s, kinds); !goal) return goal;
    if (const auto excess = trial_excess(s.world)) return Error{"[trial] duration: " + *excess};
    return setting_table::check_creatures(s, kinds);
}

}  // namespace

namespace setting_table {

void add_rhythmic_share(TableBuilder& table) {
    SettingField& rhythmic = table.number(
        &FounderSettings::rhythmic_share, "rhythmic", "Rhythmic founders", "", Range{0, 1},
        "The share of random creatures whose limbs are chains, many of them in "
        "mirrored pairs, and move at one frequency with random phases.");
    rhythmic.live = false;
    rhythmic.later = true;
}

Status check_field(const SettingField& field, const SettingRef& ref) {
    return std::visit(
        [&](const auto* at) -> Status {
            using T = std::remove_cvref_t<decltype(*at)>;
            if constexpr (std::is_same_v<T, std::string>) {
                if (field.check_text) {
                    const Status sound = field.check_text(*at);
                    return sound ? sound : Error{place(field) + ": " + sound.error().message};
                }
                if (std::find(field.choices.begin(), field.choices.end(), *at) !=
                    field.choices.end()) {
                    return {};
                }
                return Error{fmt::format("{}: unknown \"{}\"; known are {}", place(field), *at,
                                         fmt::join(field.choices, ", "))};
            } else if constexpr (std::is_same_v<T, bool>) {
                return {};
            } else {
                const double value = static_cast<double>(*at);
                if (value >= field.low && value <= field.high) return {};
                return out_of_range(field, value);
            }
        },
        ref);
}

Status check_creatures(const Settings& s, const EvolutionKinds& kinds) {
    double shares = 0.0;
    for (const BreedingKind& kind : kinds.breeding.all()) {
        const auto set = s.breeding.shares.find(kind.id);
        shares += set == s.breeding.shares.end() ? kind.default_share : set->second;
    }
    if (std::fabs(shares - 1.0) > kShareSlack) {
        return Error{fmt::format("[breeding]: the shares add up to {}; they must add up to 1",
                                 short_text(shares))};
    }
    if (Status some = check_body_kinds(s, kinds); !some) return some;
    double weights = 0.0;
    const MutationContext context{kinds.creature.catalog, s.founders};
    for (const MutationKind& kind : kinds.mutations.all()) {
        if (kind.enabled != nullptr && !kind.enabled(context)) continue;
        const auto set = s.mutation.weights.find(kind.id);
        weights += set == s.mutation.weights.end() ? kind.default_weight : set->second;
    }
    if (!(weights > 0.0) && s.mutation.scheme != "none") {
        return Error{
            "[mutation.weights]: all weights are 0; at least one must be above, or set [mutation] "
            "scheme to \"none\""};
    }
    return {};
}

Status check_founders(const Settings& s) {
    if (Status order = check_order(s.founders.min_nodes, s.founders.max_nodes, "[body] min-nodes",
                                   "max-nodes");
        !order) {
        return order;
    }
    if (Status order = check_order(s.founders.min_length, s.founders.max_length,
                                   "[body] min-length", "max-length");
        !order) {
        return order;
    }
    return check_order(s.founders.min_width, s.founders.max_width, "[body] min-width", "max-width");
}

Status check_distances(const Settings& s) {
    const Environment& world = s.world.environment;
    if (Status order = check_order(world.light_nearest, world.light_farthest,
                                   "[environment] light-nearest", "light-farthest");
        !order) {
        return order;
    }
    return check_order(world.wall_nearest, world.wall_farthest, "[environment] wall-nearest",
                       "wall-farthest");
}

}  // namespace setting_table

std::string path_of(const SettingField& field) {
    return fmt::format("{}.{}", field.table, field.key);
}

std::vector<SettingField> setting_fields(const EvolutionKinds& kinds) {
    std::vector<SettingField> fields;
    add_run(fields, kinds);
    setting_table::add_goal(fields, kinds);
    setting_table::add_environment(fields);
    add_simulation(fields, kinds);
    add_trial(fields);
    add_population(fields);
    setting_table::add_selection(fields, kinds);
    add_breeding(fields, kinds);
    add_mutation(fields, kinds);
    add_body(fields);
    setting_table::add_body_kinds(fields, kinds);
    if (kinds.creature.scene.dimensions == 3) setting_table::adapt_to_space(fields);
    return fields;
}

Status check_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    Settings copy = settings;
    for (const SettingField& field : setting_fields(kinds)) {
        if (Status fault = setting_table::check_field(field, field.at(copy)); !fault) return fault;
    }
    if (kinds.creature.scene.dimensions == 3) {
        if (Status built = setting_table::check_space(settings, kinds); !built) return built;
    }
    return check_together(settings, kinds);
}

}  // namespace cambrian
