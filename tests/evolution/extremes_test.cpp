// Settings at the ends of their ranges. Every trial must end with a verdict.

#include "core/random.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/fields/setting_field.h"
#include "genome/founders/random_genome.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

using namespace cambrian;
using test::kinds;

namespace {

bool is_finite(const EvaluationResult& result) {
    const SceneAudit& audit = result.audit;
    const double numbers[] = {result.fitness,        result.body_length,      result.mass,
                              audit.motor_work,      audit.gross_motor_work,  audit.drag_work,
                              audit.contact_work,    audit.limit_work,        audit.impulse_work,
                              audit.positive_work,   audit.energy_residual,   audit.energy_scale,
                              audit.max_penetration, audit.max_limit_overrun, audit.max_part_speed,
                              audit.max_part_spin};
    return std::all_of(std::begin(numbers), std::end(numbers),
                       [](double number) { return std::isfinite(number); });
}

EvaluationResult judged(const GenomePtr& genome, const ExperimentSettings& settings) {
    const Status valid = check_settings(settings, kinds());
    INFO((valid ? std::string() : valid.error().message));
    REQUIRE(valid);
    EvaluationResult result = evaluate({.genome = genome}, settings, kinds());
    INFO(outcome_name(result.outcome) << ": " << result.reason);
    CHECK(is_finite(result));
    CHECK(result.outcome != Outcome::kInterrupted);
    CHECK((result.outcome == Outcome::kCompleted) == result.reason.empty());
    // The budget includes one extra second, and the step that exceeds it is finished.
    const double seconds = settings.world.trial.duration + settings.world.trial.settle_limit + 1;
    CHECK(static_cast<double>(result.audit.evaluations) <=
          settings.world.scene.max_evaluations * seconds + 10);
    return result;
}

GenomePtr random_creature(RandomStream& random, const FounderSettings& founders) {
    return std::make_shared<const Genome>(random_genome(founders, test::kind_catalog(), random));
}

// Returns the settings of world and physics; those of breeding have no influence on a trial.
std::vector<SettingField> fields_of_trials() {
    std::vector<SettingField> fields = setting_fields(kinds());
    const std::set<std::string> tables = {"environment", "simulation", "trial"};
    std::erase_if(fields, [&](const SettingField& field) { return !tables.contains(field.table); });
    return fields;
}

void put(const SettingField& field, ExperimentSettings& settings, double value) {
    const SettingRef ref = field.at(settings);
    if (auto* const* real = std::get_if<double*>(&ref)) **real = value;
    if (auto* const* flag = std::get_if<bool*>(&ref)) **flag = value != 0.0;
}

// Puts the two distances of the lamp's jumps and of the wall in order, which the settings ask for.
void order_distances(Environment& environment) {
    if (environment.wall_nearest > environment.wall_farthest)
        std::swap(environment.wall_nearest, environment.wall_farthest);
    if (environment.light_nearest > environment.light_farthest)
        std::swap(environment.light_nearest, environment.light_farthest);
}

// Sets a random choice, or a number at either end of its range or at its default.
void put_extreme(const SettingField& field, ExperimentSettings& settings, RandomStream& random) {
    if (field.choices.empty()) {
        const std::size_t end = random.below(3);
        if (end < 2) put(field, settings, end == 0 ? field.low : field.high);
    } else {
        *std::get<std::string*>(field.at(settings)) =
            field.choices[random.below(field.choices.size())];
    }
}

}  // namespace

TEST_CASE("every setting of the physics at either end of its range gives a verdict",
          "[evolution][extremes]") {
    RandomStream random(stream_seed({7, 1}));
    for (const SettingField& field : fields_of_trials()) {
        for (const double value : {field.low, field.high}) {
            for (int creature = 0; creature < 4; ++creature) {
                ExperimentSettings settings;
                settings.world.trial.duration = 0.5;
                settings.world.trial.settle_limit = 0.5;
                const double longest = 60.0;  // s; longer trials would only take longer
                put(field, settings, field.key == "duration" ? std::min(value, longest) : value);
                order_distances(settings.world.environment);
                INFO(field.key << " = " << value << ", creature " << creature);
                judged(creature == 0 ? test::crawler(test::kind_catalog())
                                     : random_creature(random, settings.founders),
                       settings);
            }
        }
    }
}

TEST_CASE("random extremes of the world, the physics and the body give a verdict",
          "[evolution][extremes]") {
    int completed = 0;
    const std::uint64_t rounds = test::by_build<std::uint64_t>(300, 50);
    for (std::uint64_t round = 0; round < rounds; ++round) {
        RandomStream random(stream_seed({round, 7, 2}));
        ExperimentSettings settings;
        for (const SettingField& field : fields_of_trials())
            put_extreme(field, settings, random);
        order_distances(settings.world.environment);
        // Ground with a shape excludes contests, walls and some lamps.
        if (!check_settings(settings, kinds())) settings.world.environment.terrain = {};
        settings.world.trial.duration = random.chance(0.1) ? 0.0 : 0.3;
        settings.world.trial.settle_limit = random.chance(0.5) ? 0.0 : 0.3;
        settings.world.scene.max_evaluations = random.chance(0.2) ? 1e3 : 2e4;
        FounderSettings& founders = settings.founders;
        const bool tiny = random.chance(0.5);
        founders.max_nodes = 16;
        founders.max_recursion = 6;
        founders.min_length = tiny ? 0.08 : 1.6;
        founders.max_length = random.chance(0.5) ? founders.min_length : 1.6;
        founders.min_width = tiny ? 0.08 : 0.96;
        founders.max_width = random.chance(0.5) ? founders.min_width : 0.96;
        founders.joints = {{"rigid", true}, {"rotary", true}, {"linear", true}};
        INFO("round " << round);
        const EvaluationResult result = judged(random_creature(random, founders), settings);
        completed += result.outcome == Outcome::kCompleted ? 1 : 0;
    }
    CHECK(completed > 0);
}

TEST_CASE("motion too stiff to compute is given up with a reason", "[evolution][extremes]") {
    ExperimentSettings settings;
    settings.world.environment.viscosity_linear = 1e4;
    settings.world.environment.density = 1e-3;
    const EvaluationResult result = judged(test::crawler(test::kind_catalog()), settings);
    CHECK(result.outcome == Outcome::kOverBudget);
    CHECK(result.verdict == AuditVerdict::kInvalid);
    CHECK(result.fitness == 0.0);
    CHECK(result.reason.find("50000 evaluations a second") != std::string::npos);
}

TEST_CASE("a small work limit gives up what a larger one computes", "[evolution][extremes]") {
    ExperimentSettings settings;
    settings.world.scene.tolerance = 1e-8;
    settings.world.trial.duration = 3.0;
    CHECK(judged(test::crawler(test::kind_catalog()), settings).outcome == Outcome::kCompleted);
    settings.world.scene.max_evaluations = 1e3;
    CHECK(judged(test::crawler(test::kind_catalog()), settings).outcome == Outcome::kOverBudget);
}

TEST_CASE("a trial of 10000 s can be stopped, one of ordinary length is finished",
          "[evolution][extremes]") {
    std::stop_source stop;
    stop.request_stop();
    ExperimentSettings settings;
    const GenomePtr genome = test::crawler(test::kind_catalog());
    CHECK(evaluate({.genome = genome}, settings, kinds(), stop.get_token()).outcome ==
          Outcome::kCompleted);
    settings.world.trial.duration = 1e4;
    const EvaluationResult cut = evaluate({.genome = genome}, settings, kinds(), stop.get_token());
    CHECK(cut.outcome == Outcome::kInterrupted);
    CHECK(cut.audit.evaluations < 110000);
}

TEST_CASE("what is interrupted is no result of its generation", "[evolution][extremes][threads]") {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->world.trial.duration = 1e4;
    const std::vector<EvaluationRequest> requests(3,
                                                  {.genome = test::crawler(test::kind_catalog())});
    std::vector<std::optional<EvaluationResult>> results(requests.size());
    const auto backend = make_thread_pool_backend(kinds(), 2);
    EvaluationProgress progress;
    std::stop_source stop;
    std::jthread impatient([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        stop.request_stop();
    });
    CHECK_FALSE(backend->evaluate(requests, results, *settings, progress, stop.get_token()));
    for (const auto& result : results)
        CHECK_FALSE(result.has_value());
    CHECK(progress.done == 0);
}
