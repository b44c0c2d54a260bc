#include "evolution/fields/setting_field.h"

#include "core/text/number_text.h"
#include "evolution/fields/setting_table.h"
#include "evolution/selections/survival.h"
#include "evolution/settings/trial_work.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace cambrian {
namespace {

constexpr double kShareSlack = 0.01;  // tolerance of a sum of shares, for rounded thirds

using setting_table::ids_of;
using setting_table::Range;
using setting_table::Settings;
using setting_table::TableBuilder;

void add_run(std::vector<SettingField>& fields) {
    TableBuilder run(fields, "run");
    run.number(
           "seed", "Seed", "", Range{0, 1e15},
           "Every random choice follows from it: same seed, same evolution.",
           [](Settings & s) -> auto& { return s.seed; })
        .live = false;
    run.number(
        "generations", "Generations", "", Range{1, 1e6},
        "An unattended run stops after this many generations.",
        [](Settings & s) -> auto& { return s.generations; });
    run.number(
        "max-evaluations", "Evaluations", "", Range{1, 1e9},
        "An unattended run stops after the generation in which it reaches this many trials.",
        [](Settings & s) -> auto& { return s.max_evaluations; });
    run.number(
        "target-fitness", "Target fitness", "", Range{0, 1e6},
        "An unattended run stops once the best reaches this; 0 for no target.",
        [](Settings & s) -> auto& { return s.target_fitness; });
    run.flag(
        "stop-hopeless", "Stop hopeless trials",
        "Halfway, gives up creatures that could not survive even at 1.5 times their best speed; "
        "10 % of them, and the first 30, are finished all the same, to tell whether that was "
        "right.",
        [](Settings & s) -> auto& { return s.terminate_early; });
}

void add_simulation(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder table(fields, "simulation");
    table.choice(
        "integrator", "Integrator", kinds.creature.scene.integrators,
        "How motion is computed from forces.",
        [](Settings & s) -> auto& { return s.world.scene.integrator; });
    table
        .number(
            "tolerance", "Tolerance", "", Range{1e-8, 1e-1},
            "Error allowed in a step; smaller is more exact and slower.",
            [](Settings & s) -> auto& { return s.world.scene.tolerance; })
        .logarithmic = true;
    table
        .number(
            "contact-step", "Contact step", "s", Range{1e-4, 1.0 / 60},
            "Longest step while parts touch anything or joints meet their limits.",
            [](Settings & s) -> auto& { return s.world.scene.contact_step; })
        .logarithmic = true;
    table
        .number(
            "max-evaluations", "Work limit", "evaluations/s", Range{1e3, 1e6},
            "A trial whose motion takes more computing for each simulated second is given up.",
            [](Settings & s) -> auto& { return s.world.scene.max_evaluations; })
        .logarithmic = true;
    table.number(
        "muscle-strength", "Muscle strength", "N/m", Range{0, 1e4},
        "Strongest torque of a joint for each square metre of its narrower part's width.",
        [](Settings & s) -> auto& { return s.world.scene.muscle_strength; });
    table.number(
        "target-smoothing", "Muscle smoothing", "s", Range{0, 10},
        "Time a joint takes to follow its brain; larger is calmer.",
        [](Settings & s) -> auto& { return s.world.scene.target_smoothing; });
    table.number(
        "motor-speed-limit", "Joint speed limit", "rad/s", Range{0, 100},
        "Fastest turn a joint's muscle asks for.",
        [](Settings & s) -> auto& { return s.world.scene.motor_speed_limit; });
    table.number(
        "motor-frequency", "Muscle stiffness", "rad/s", Range{0.1, 200},
        "How sharply a muscle corrects a joint that is off its target.",
        [](Settings & s) -> auto& { return s.world.scene.motor_frequency; });
    table
        .choice(
            "motor-mode", "Brains set", {kMotorModeIds.begin(), kMotorModeIds.end()},
            "What a brain sets of a joint: the position it moves to, its speed, or its torque.",
            [](Settings & s) -> auto& { return s.world.scene.motor_mode; })
        .live = false;
    table.number(
        "brain-steps", "Thoughts a tick", "", Range{1, 2},
        "How often a brain thinks in each sixtieth of a second.",
        [](Settings & s) -> auto& { return s.world.scene.brain_steps; });
}

void add_trial(std::vector<SettingField>& fields) {
    TableBuilder table(fields, "trial");
    table.number(
        "duration", "Duration", "s", Range{0, 1e4}, "Time in which a creature is judged.",
        [](Settings & s) -> auto& { return s.world.trial.duration; });
    table.number(
        "settle-limit", "Settling", "s", Range{0, 60},
        "Longest time a creature may come to rest on the ground before it is judged.",
        [](Settings & s) -> auto& { return s.world.trial.settle_limit; });
    table.flag(
        "limp-settle", "Settle limp",
        "Creatures come to rest without muscles and without friction, instead of holding their "
        "rest pose.",
        [](Settings & s) -> auto& { return s.world.trial.settle_motors_off; });
    table.number(
        "max-part-speed", "Speed guard", "m/s", Range{1, 1e4},
        "A creature with a part faster than this is disqualified.",
        [](Settings & s) -> auto& { return s.world.trial.max_part_speed; });
    table.number(
        "max-part-spin", "Spin guard", "rad/s", Range{1, 1e4},
        "A creature with a part that spins faster than this is disqualified.",
        [](Settings & s) -> auto& { return s.world.trial.max_part_spin; });
    table.number(
        "max-ground-depth", "Ground guard", "m", Range{1e-3, 10},
        "A creature that stays deeper in the ground than this is disqualified.",
        [](Settings & s) -> auto& { return s.world.trial.max_ground_depth; });
    table.number(
        "max-reversal-rate", "Shaking guard", "Hz", Range{0.1, 1e3},
        "Joints that shake faster than this have their score scaled down.",
        [](Settings & s) -> auto& { return s.world.trial.max_reversal_rate; });
    table.flag(
        "stop-at-rest", "Stop at rest",
        "Ends the trial of a creature that lies still for 2 s, body and brain; its score is known.",
        [](Settings & s) -> auto& { return s.world.trial.stop_at_rest; });
    setting_table::add_trials(table);
}

void add_population(std::vector<SettingField>& fields) {
    TableBuilder table(fields, "population");
    table.number(
        "size", "Population size", "creatures", Range{2, 20000}, "Creatures a generation.",
        [](Settings & s) -> auto& { return s.population.size; });
    table.number(
        "immigrants", "Newcomers", "creatures", Range{0, 20000},
        "Places of each generation given to new random creatures.",
        [](Settings & s) -> auto& { return s.population.immigrants; });
    table
        .choice(
            "fill", "Fill up with", {"mutants", "random"},
            "Where founders are given: what takes the places they leave, mutants of them or random "
            "creatures.",
            [](Settings & s) -> auto& { return s.population.fill; })
        .live = false;
}

void add_breeding(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder breeding(fields, "breeding");
    breeding.choice(
        "choice", "Chosen by", {"shares", "attribute"},
        "The shares below, or an attribute of each creature that it inherits and that mutates.",
        [](Settings & s) -> auto& { return s.breeding.choice; });
    for (const BreedingKind& kind : kinds.breeding.all()) {
        breeding.number(
            kind.id, kind.label, "", Range{0, 1},
            "Share of the offspring made this way; the shares of all ways add up to 1.",
            [ id = kind.id, standard = kind.default_share ](Settings & s) -> auto& {
                return s.breeding.shares.try_emplace(id, standard).first->second;
            });
    }
}

void add_mutation(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder mutation(fields, "mutation");
    mutation.choice(
        "scheme", "Scheme", {"count-first", "gate", "none"},
        "How the number of mutations of an offspring is drawn.",
        [](Settings & s) -> auto& { return s.mutation.scheme; });
    mutation.number(
        "rate", "Mutation rate", "x", Range{0, 8},
        "Scales the mutations of an offspring; 1 means none in 25 %, one in 50 % and "
        "more in 25 % of them.",
        [](Settings & s) -> auto& { return s.mutation.rate; });
    mutation.flag(
        "collect-mute-neurons", "Drop mute neurons",
        "Removes neurons that no joint can hear; otherwise they wait for a connection.",
        [](Settings & s) -> auto& { return s.mutation.collect_mute_neurons; });
    TableBuilder weights(fields, "mutation.weights");
    for (const MutationKind& kind : kinds.mutations.all()) {
        weights.number(
            kind.id, kind.label, "", Range{0, 1000},
            "How often this kind of mutation is drawn, relative to the others.",
            [ id = kind.id, standard = kind.default_weight ](Settings & s) -> auto& {
                return s.mutation.weights.try_emplace(id, standard).first->second;
            });
    }
}

void add_body(std::vector<SettingField>& fields) {
    TableBuilder body(fields, "body");
    const auto structural = [&](auto&&... arguments) {
        body.number(std::forward<decltype(arguments)>(arguments)...).live = false;
    };
    structural(
        "max-parts", "Parts at most", "", Range{2, 32}, "A grown body stops at this many parts.",
        [](Settings & s) -> auto& { return s.expression.max_parts; });
    structural(
        "max-depth", "Depth at most", "", Range{1, 32},
        "Joints between the root and the farthest part.",
        [](Settings & s) -> auto& { return s.expression.max_depth; });
    structural(
        "max-neurons", "Neurons at most", "", Range{1, 4096},
        "A grown brain stops at this many neurons.",
        [](Settings & s) -> auto& { return s.expression.max_neurons; });
    body.flag(
            "strict-overlap", "No overlap",
            "Rejects bodies in which parts overlap that no joint ties together; otherwise these "
            "pass "
            "through each other.",
            [](Settings & s) -> auto& { return s.expression.strict_overlap; })
        .live = false;
    structural(
        "min-nodes", "Founder nodes, least", "", Range{1, 16},
        "Part genes of a random creature, at least.",
        [](Settings & s) -> auto& { return s.founders.min_nodes; });
    structural(
        "max-nodes", "Founder nodes, most", "", Range{1, 16},
        "Part genes of a random creature, at most.",
        [](Settings & s) -> auto& { return s.founders.max_nodes; });
    structural(
        "min-length", "Founder length, least", "m", Range{0.08, 1.6}, "Shortest random part.",
        [](Settings & s) -> auto& { return s.founders.min_length; });
    structural(
        "max-length", "Founder length, most", "m", Range{0.08, 1.6}, "Longest random part.",
        [](Settings & s) -> auto& { return s.founders.max_length; });
    structural(
        "min-width", "Founder width, least", "m", Range{0.08, 0.96}, "Thinnest random part.",
        [](Settings & s) -> auto& { return s.founders.min_width; });
    structural(
        "max-width", "Founder width, most", "m", Range{0.08, 0.96}, "Thickest random part.",
        [](Settings & s) -> auto& { return s.founders.max_width; });
    structural(
        "moving-share", "Moving joints", "", Range{0, 1},
        "Share of a random creature's joints that move.",
        [](Settings & s) -> auto& { return s.founders.rotary_share; });
    structural(
        "symmetric-share", "Symmetry", "", Range{0, 1},
        "Share of a random creature's parts that grow as mirror pairs.",
        [](Settings & s) -> auto& { return s.founders.symmetric_share; });
    structural(
        "max-recursion", "Founder recursion", "", Range{1, 6},
        "How often a random part may repeat along a limb.",
        [](Settings & s) -> auto& { return s.founders.max_recursion; });
    structural(
        "node-neurons", "Founder neurons a part", "", Range{0, 8},
        "Neurons in each part of a random creature, at most.",
        [](Settings & s) -> auto& { return s.founders.max_node_neurons; });
    structural(
        "brain-neurons", "Founder central neurons", "", Range{0, 16},
        "Central neurons of a random creature, at most.",
        [](Settings & s) -> auto& { return s.founders.max_brain_neurons; });
}

std::string place(const SettingField& field) {
    return "[" + field.table + "] " + field.key;
}

Status out_of_range(const SettingField& field, double value) {
    return Error{place(field) + ": " + short_text(value) +
                 (std::isfinite(value) ? " is outside " : " is not finite; expected ") + "[" +
                 short_text(field.low) + ", " + short_text(field.high) + "]"};
}

Status check_field(const SettingField& field, const SettingRef& ref) {
    return std::visit(
        [&](const auto* at) -> Status {
            using T = std::remove_cvref_t<decltype(*at)>;
            if constexpr (std::is_same_v<T, std::string>) {
                if (std::find(field.choices.begin(), field.choices.end(), *at) !=
                    field.choices.end()) {
                    return {};
                }
                std::string known;
                for (const std::string& choice : field.choices) {
                    known += (known.empty() ? "" : ", ") + choice;
                }
                return Error{place(field) + ": unknown \"" + *at + "\"; known are " + known};
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

Status check_order(double low, double high, const char* low_key, const char* high_key) {
    if (low <= high) return {};
    return Error{std::string("[body] ") + low_key + ": " + short_text(low) + " is above " +
                 high_key + ", which is " + short_text(high)};
}

Status check_early_termination(const Settings& s, const EvolutionKinds& kinds) {
    if (!s.terminate_early) return {};
    const GoalKind* goal = kinds.goals.find(s.goal);
    if (goal != nullptr && !goal->may_give_up) {
        return Error{"[run] stop-hopeless: not with [goal] behavior \"" + s.goal +
                     "\", whose score may still rise by more than speed so far tells"};
    }
    const SelectionKind* selection = kinds.selections.find(s.selection.method);
    if (selection != nullptr && !(termination_share(*selection, s.selection) > 0.0)) {
        return Error{"[run] stop-hopeless: not with [selection] method \"" + s.selection.method +
                     "\", where the least fit may matter; allowed with truncation, rank and "
                     "tournaments of survivors"};
    }
    if (s.world.trial.trials > 1) {
        return Error{"[run] stop-hopeless: needs [trial] trials = 1, which is " +
                     std::to_string(s.world.trial.trials)};
    }
    return {};
}

// Rejects settings that are in range one by one but contradict one another.
Status check_together(const Settings& s, const EvolutionKinds& kinds) {
    if (Status order =
            check_order(s.founders.min_nodes, s.founders.max_nodes, "min-nodes", "max-nodes");
        !order) {
        return order;
    }
    if (Status order =
            check_order(s.founders.min_length, s.founders.max_length, "min-length", "max-length");
        !order) {
        return order;
    }
    if (Status order =
            check_order(s.founders.min_width, s.founders.max_width, "min-width", "max-width");
        !order) {
        return order;
    }
    if (Status goal = setting_table::check_goal(s, kinds); !goal) return goal;
    if (Status cutting = check_early_termination(s, kinds); !cutting) return cutting;
    if (const auto excess = trial_excess(s.world)) return Error{"[trial] duration: " + *excess};
    double shares = 0.0;
    for (const BreedingKind& kind : kinds.breeding.all()) {
        const auto set = s.breeding.shares.find(kind.id);
        shares += set == s.breeding.shares.end() ? kind.default_share : set->second;
    }
    if (std::fabs(shares - 1.0) > kShareSlack) {
        return Error{"[breeding]: the shares add up to " + short_text(shares) +
                     "; they must add up to 1"};
    }
    if (Status some = setting_table::check_body_kinds(s, kinds); !some) return some;
    double weights = 0.0;
    for (const MutationKind& kind : kinds.mutations.all()) {
        const auto set = s.mutation.weights.find(kind.id);
        weights += set == s.mutation.weights.end() ? kind.default_weight : set->second;
    }
    if (!(weights > 0.0)) {
        return Error{
            "[mutation.weights]: all weights are 0; at least one must be above, or set "
            "[mutation] scheme to \"none\""};
    }
    return {};
}

}  // namespace

std::vector<SettingField> setting_fields(const EvolutionKinds& kinds) {
    std::vector<SettingField> fields;
    add_run(fields);
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
    return fields;
}

Status check_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    Settings copy = settings;
    for (const SettingField& field : setting_fields(kinds)) {
        if (Status fault = check_field(field, field.at(copy)); !fault) return fault;
    }
    return check_together(settings, kinds);
}

}  // namespace cambrian
