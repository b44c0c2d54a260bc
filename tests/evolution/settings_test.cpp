#include "evolution/fields/setting_field.h"
#include "evolution/settings/goal_defaults.h"
#include "genome/founders/random_genome.h"
#include "genome/source_rules.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

using namespace cambrian;
using test::kinds;

TEST_CASE("default settings are valid", "[evolution][settings]") {
    CHECK(check_settings(ExperimentSettings{}, kinds()).has_value());
}

TEST_CASE("every field has a unique name, a label and a sentence of help",
          "[evolution][settings]") {
    std::set<std::string> names;
    for (const SettingField& field : setting_fields(kinds())) {
        CHECK(names.insert(field.table + "." + field.key).second);
        CHECK_FALSE(field.label.empty());
        CHECK(field.help.size() > 10);
        CHECK(field.help.back() == '.');
    }
    CHECK(names.size() > 40);
}

TEST_CASE("every choice has a label, that of its kind if it is one", "[evolution][settings]") {
    std::map<std::string, std::string> labels;
    for (const SettingField& field : setting_fields(kinds())) {
        REQUIRE(field.choice_labels.size() == field.choices.size());
        for (std::size_t i = 0; i < field.choices.size(); ++i)
            labels[field.choices[i]] = field.choice_labels[i];
    }
    CHECK(labels.at("bogacki-shampine") == "Bogacki-Shampine");
    CHECK(labels.at("map-elites") == "MAP-Elites");
    CHECK(labels.at("count-first") == "Count first");
}

TEST_CASE("a number outside its range is an error that names it", "[evolution][settings]") {
    for (const SettingField& field : setting_fields(kinds())) {
        ExperimentSettings settings;
        const SettingRef ref = field.at(settings);
        if (auto* const* real = std::get_if<double*>(&ref)) {
            for (const double bad :
                 {field.high * 2 + 1, field.low - 1.0, std::numeric_limits<double>::quiet_NaN(),
                  std::numeric_limits<double>::infinity()}) {
                **real = bad;
                const Status status = check_settings(settings, kinds());
                REQUIRE_FALSE(status);
                CHECK(status.error().message.find(field.key) != std::string::npos);
            }
        } else if (auto* const* whole = std::get_if<int*>(&ref)) {
            **whole = static_cast<int>(field.low) - 1;
            CHECK_FALSE(check_settings(settings, kinds()));
        } else if (auto* const* text = std::get_if<std::string*>(&ref)) {
            **text = "no-such-thing";
            const Status status = check_settings(settings, kinds());
            REQUIRE_FALSE(status);
            CHECK_THAT(status.error().message,
                       Catch::Contains(field.check_text ? field.key : "no-such-thing"));
        }
    }
}

TEST_CASE("crossed limits and shares that are all zero are errors", "[evolution][settings]") {
    ExperimentSettings crossed;
    crossed.founders.min_nodes = 6;
    CHECK(check_settings(crossed, kinds()).error().message.find("min-nodes") != std::string::npos);
    ExperimentSettings shareless;
    for (const BreedingKind& kind : kinds().breeding.all())
        shareless.breeding.shares[kind.id] = 0;
    CHECK(check_settings(shareless, kinds()).error().message.find("[breeding]") !=
          std::string::npos);
    shareless.breeding.shares["asexual"] = 0.9;
    shareless.breeding.shares["crossover"] = 0.7;
    CHECK(check_settings(shareless, kinds()).error().message ==
          "[breeding]: the shares add up to 1.6; they must add up to 1");
    ExperimentSettings weightless;
    for (const MutationKind& kind : kinds().mutations.all()) {
        weightless.mutation.weights[kind.id] = 0;
    }
    CHECK_FALSE(check_settings(weightless, kinds()));
}

TEST_CASE("trials that take too long to judge one creature are an error", "[evolution][settings]") {
    ExperimentSettings settings;
    settings.world.trial.trials = 50;
    CHECK(check_settings(settings, kinds()).has_value());
    settings.world.trial.duration = 1e4;
    CHECK(check_settings(settings, kinds()).error().message ==
          "[trial] duration: 50 trials of 10000 s, 500000 s in all; limit 10000 s");
    settings.world.trial.trials = 1;
    CHECK(check_settings(settings, kinds()).error().message ==
          "[trial] duration: 1 trial of 10000 s and 3 s of settling, at up to 50000 "
          "evaluations/s 500150000 in all; limit 200000000");
    settings.world.scene.max_evaluations = 1e4;
    CHECK(check_settings(settings, kinds()).has_value());
}

TEST_CASE("populations of none, one and too many are errors that name the range",
          "[evolution][settings]") {
    for (const int size : {-1, 0, 1, 20001}) {
        ExperimentSettings settings;
        settings.population.size = size;
        CHECK(check_settings(settings, kinds()).error().message ==
              "[population] size: " + std::to_string(size) + " is outside [2, 20000]");
    }
    ExperimentSettings endless;
    endless.generations = 1'000'000'000;
    CHECK(check_settings(endless, kinds()).error().message ==
          "[run] generations: 1000000000 is outside [1, 1000000]");
}

TEST_CASE("nothing to build a body or a brain from is an error", "[evolution][settings]") {
    const KindCatalog& catalog = kinds().creature.catalog;
    ExperimentSettings stiff;
    for (const JointChoice& joint : catalog.joints)
        stiff.founders.joints[joint.id] = joint.degrees_of_freedom == 0;
    CHECK(check_settings(stiff, kinds()).error().message.find("[body.joints]") == 0);
    ExperimentSettings jointless;
    for (const JointChoice& joint : catalog.joints)
        jointless.founders.joints[joint.id] = false;
    CHECK(check_settings(jointless, kinds()).error().message.find("[body.joints]") == 0);
    ExperimentSettings brainless;
    for (const FunctionEntry& function : catalog.functions)
        brainless.founders.functions[function.id] = false;
    CHECK(check_settings(brainless, kinds()).error().message.find("[body.functions]") == 0);
    brainless.founders.functions["sum"] = true;
    CHECK(check_settings(brainless, kinds()).has_value());
}

TEST_CASE("references that leave joints or central neurons nothing to read are an error",
          "[evolution][settings]") {
    ExperimentSettings cut;
    for (const SourceRule& rule : source_rules())
        cut.founders.references[std::string(rule.id)] = false;
    const std::string jointless =
        "[body.references]: joints would have nothing to follow; at least one must be true of "
        "localNeuron, localSensor, parentNeuron, parentSensor, childNeuron, childSensor, "
        "brainNeuron";
    CHECK(check_settings(cut, kinds()).error().message == jointless);
    cut.founders.references["const"] = true;
    CHECK(check_settings(cut, kinds()).error().message == jointless);
    cut.founders.references["localSensor"] = true;
    CHECK(check_settings(cut, kinds()).has_value());
    cut.founders.references["const"] = false;
    CHECK(check_settings(cut, kinds()).error().message ==
          "[body.references]: central neurons would have nothing to read; at least one must be "
          "true of const, brainNeuron, partNeuron, partSensor");
    cut.founders.references["partSensor"] = true;
    CHECK(check_settings(cut, kinds()).has_value());
    for (const ChannelEntry& channel : kinds().creature.catalog.channels)
        cut.founders.channels[channel.id] = false;
    CHECK(check_settings(cut, kinds()).error().message ==
          "[body.references]: joints would have nothing to follow; at least one must be true of "
          "localNeuron, parentNeuron, childNeuron, brainNeuron");
}

TEST_CASE("a goal that follows a light says what it lacks", "[evolution][settings]") {
    ExperimentSettings settings;
    settings.goal = "seeking";
    CHECK(check_settings(settings, kinds()).error().message ==
          "goal \"seeking\" has no light: set [environment] light = true");
    settings.world.environment.has_light = true;
    CHECK(check_settings(settings, kinds()).error().message ==
          "goal \"seeking\" has a light but no creature may see it: set [body.sensors] "
          "light-along = true");
    settings.founders.channels["light-across"] = true;
    CHECK(check_settings(settings, kinds()).has_value());
    CHECK(setting_warnings(settings, kinds()).front().find("the light does not jump") !=
          std::string::npos);
    settings.world.environment.light_motion = "jumping";
    REQUIRE(setting_warnings(settings, kinds()).size() == 1);
    CHECK(setting_warnings(settings, kinds()).front().find("mirror image") != std::string::npos);
    settings.world.trial.trials = 2;
    CHECK(setting_warnings(settings, kinds()).empty());
    settings.world.environment.light_x = std::nan("");
    CHECK(check_settings(settings, kinds()).error().message.find("[environment] light-x") == 0);
}

TEST_CASE("ground with a shape says what it lacks and where it is not built",
          "[evolution][settings][terrain]") {
    const auto fault = [](const ExperimentSettings& settings) {
        const Status checked = check_settings(settings, kinds());
        return checked ? std::string() : checked.error().message;
    };
    ExperimentSettings settings;
    TerrainSettings& terrain = settings.world.environment.terrain;
    for (const std::string_view kind : kTerrainIds) {
        terrain.kind = kind;
        INFO(kind);
        CHECK((fault(settings) == "") == (kind != "drawn"));
    }
    CHECK_THAT(fault(settings), Catch::Contains("terrain-points") && Catch::Contains("at least 2"));
    terrain.points = "0 0; 3 1";
    CHECK(fault(settings).empty());
    settings.world.environment.has_ground = false;
    CHECK_THAT(fault(settings), Catch::Contains("there is no ground"));
    settings.world.environment.has_ground = true;
    settings.world.trial.has_cube = true;
    CHECK_THAT(fault(settings), Catch::Contains("flat ground"));
    settings.world.trial.has_cube = false;
    settings.world.environment.has_light = true;
    settings.world.environment.light_motion = "jumping";
    CHECK_THAT(fault(settings), Catch::Contains("a light that moves"));
    settings.world.environment.has_light = false;
    terrain.kind = "hills";
    CHECK_THAT(setting_warnings(settings, kinds()).back(), Catch::Contains("terrain-points"));
    ExperimentSettings preserve = preserve_defaults(kinds(), true);
    CHECK(check_preserve(preserve, kinds()).has_value());
    preserve.world.environment.terrain.kind = "hills";
    CHECK(check_preserve(preserve, kinds()).has_value());
    // Plants in a pit would bind all energy.
    preserve.world.environment.terrain.kind = "gaps";
    CHECK_THAT(check_preserve(preserve, kinds()).error().message, Catch::Contains("terrain"));
}

TEST_CASE("hopeless trials end early by default where that saves time", "[evolution][settings]") {
    for (const GoalKind& goal : kinds().goals.all()) {
        ExperimentSettings settings;
        settings.goal = goal.id;
        adopt_defaults(settings, goal);
        CAPTURE(goal.id);
        CHECK(settings.terminate_early == (goal.id == "walking" || goal.id == "swimming"));
        CHECK(check_settings(settings, kinds()).has_value());
    }
}

TEST_CASE("early termination has an effect only where no trial that ends could matter",
          "[evolution][settings]") {
    const auto fields = setting_fields(kinds());
    const auto field = std::find_if(fields.begin(), fields.end(), [](const SettingField& each) {
        return each.key == "stop-hopeless";
    });
    REQUIRE(field != fields.end());
    ExperimentSettings settings;
    CHECK(field->applies(settings));
    for (const char* goal : {"seeking", "flying", "competition"}) {
        ExperimentSettings other;
        other.goal = goal;
        CHECK_FALSE(field->applies(other));
    }
    for (const char* method : {"roulette", "map-elites", "novelty", "age-protection"}) {
        settings.selection.method = method;
        CHECK(check_settings(settings, kinds()).has_value());
        CHECK_FALSE(field->applies(settings));
    }
    settings.selection.method = "tournament";
    CHECK(field->applies(settings));
    settings.selection.own["tournament-of-all"] = true;
    CHECK_FALSE(field->applies(settings));
    settings = {};
    settings.world.trial.trials = 2;
    CHECK_FALSE(field->applies(settings));
}

namespace {

// The keys of [selection] that have an effect under these settings, besides the method and the
// confirmations.
std::set<std::string> effective_keys(const ExperimentSettings& settings) {
    std::set<std::string> keys;
    for (const SettingField& field : setting_fields(kinds())) {
        if (field.table == "selection" && (!field.applies || field.applies(settings)))
            keys.insert(field.key);
    }
    for (const char* always : {"method", "confirmations", "confirm-jitter", "confirm-tilt"})
        CHECK(keys.erase(always) == 1);
    return keys;
}

}  // namespace

TEST_CASE("settings of selection have an effect where the method reads them",
          "[evolution][settings]") {
    using Keys = std::set<std::string>;
    const Keys share = {"survival", "max-clones", "line-share", "plan-copies"};
    Keys tournament = share;
    tournament.insert({"tournament-size", "tournament-of-all"});
    const std::map<std::string, Keys> expected = {
        {"truncation", share},
        {"rank", share},
        {"tournament", tournament},
        {"roulette", {"max-clones", "elites"}},
        {"map-elites", {"map-across", "map-up"}},
        {"novelty", {"novelty-neighbors", "novelty-threshold"}},
        {"age-protection", {}}};
    ExperimentSettings settings;
    for (const auto& [method, keys] : expected) {
        CAPTURE(method);
        settings.selection.method = method;
        CHECK(effective_keys(settings) == keys);
    }
    settings.selection.method = "tournament";
    settings.selection.own["tournament-of-all"] = true;
    CHECK(effective_keys(settings) ==
          Keys{"max-clones", "tournament-size", "tournament-of-all", "elites"});
}

TEST_CASE("a goal in its own world raises no warning", "[evolution][settings]") {
    for (const GoalKind& goal : kinds().goals.all()) {
        ExperimentSettings settings;
        settings.goal = goal.id;
        adopt_defaults(settings, goal);
        CAPTURE(goal.id);
        CHECK(setting_warnings(settings, kinds()).empty());
    }
}

TEST_CASE("a goal that is impossible in an environment gives way to one that is possible",
          "[evolution][settings]") {
    ExperimentSettings settings;
    const auto goal_in = [&settings](const Environment& environment) {
        settings.world.environment = environment;
        adopt_possible_goal(settings, kinds().goals);
        return settings.goal;
    };
    CHECK(goal_in(Environment{}) == "walking");
    settings.world.trial.trials = 3;
    CHECK(goal_in(Environment{}) == "walking");
    CHECK(settings.world.trial.trials == 3);
    CHECK(goal_in(kinds().goals.find("swimming")->default_environment()) == "swimming");
    CHECK(settings.world.trial == kinds().goals.find("swimming")->default_trial);
    CHECK(goal_in(kinds().goals.find("flying")->default_environment()) == "flying");
    settings.goal = "jumping";
    CHECK(goal_in(Environment{}) == "jumping");
    Environment space;
    space.has_ground = false;
    space.gravity = 0.0;
    CHECK(goal_in(space) == "jumping");  // nothing is possible there
}

TEST_CASE("a goal in a world where it makes no sense warns and is allowed",
          "[evolution][settings]") {
    const auto warned = [](const ExperimentSettings& settings) {
        CHECK(check_settings(settings, kinds()).has_value());
        const auto warnings = setting_warnings(settings, kinds());
        return warnings.size() == 1 && warnings[0].find("[goal] behavior: " + settings.goal) == 0;
    };
    ExperimentSettings settings;
    settings.goal = "swimming";  // its world has ground and no viscosity
    CHECK(warned(settings));
    settings.world.environment = kinds().goals.find("swimming")->default_environment();
    settings.world.environment.gravity = 9.81;
    CHECK(warned(settings));
    for (const char* goal : {"walking", "jumping"}) {
        settings.goal = goal;
        settings.world.environment = Environment{};
        settings.world.environment.has_ground = false;
        CHECK(warned(settings));
        settings.world.environment = Environment{};
        settings.world.environment.gravity_direction = 90.0;
        CHECK(warned(settings));
    }
}

TEST_CASE("senses beyond joints and touch are switches that are off", "[evolution][settings]") {
    ExperimentSettings settings;
    int off = 0;
    for (const SettingField& field : setting_fields(kinds())) {
        if (field.table != "body.sensors") continue;
        INFO(field.key);
        const bool old = field.key == "joint" || field.key.starts_with("contact-");
        CHECK(*std::get<bool*>(field.at(settings)) == old);
        off += old ? 0 : 1;
    }
    CHECK(off > 0);
}

TEST_CASE("random creatures do not depend on senses that are off", "[evolution][settings]") {
    const KindCatalog& now = kinds().creature.catalog;
    KindCatalog before = now;
    std::erase_if(before.channels, [](const ChannelEntry& channel) { return !channel.usual; });
    REQUIRE(before.channels.size() == 5);
    RandomStream stream(7);
    RandomStream same(7);
    for (int i = 0; i < 200; ++i)
        REQUIRE(random_genome({}, now, stream) == random_genome({}, before, same));
}

TEST_CASE("kinds of organs are switches that are off", "[evolution][settings]") {
    ExperimentSettings settings;
    std::size_t switches = 0;
    for (const SettingField& field : setting_fields(kinds())) {
        if (field.table != "body.organs") continue;
        ++switches;
        INFO(field.key);
        CHECK_FALSE(*std::get<bool*>(field.at(settings)));
        CHECK(field.later);
    }
    CHECK(switches == kinds().creature.catalog.organs.size());
}

TEST_CASE("mutations of organs do not count while no kind is allowed", "[evolution][settings]") {
    ExperimentSettings settings;
    for (const MutationKind& kind : kinds().mutations.all())
        settings.mutation.weights[kind.id] = kind.enabled == nullptr ? 0.0 : 1.0;
    const Status refused = check_settings(settings, kinds());
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, Catch::StartsWith("[mutation.weights]: all weights are 0"));
    settings.founders.organs["sound"] = true;
    CHECK(check_settings(settings, kinds()).has_value());
}
