// Lesions of grown creatures, what they cost, and pruning.
#include "core/sample_statistics.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evaluation/lesion_table.h"
#include "evolution/evaluation/pruning.h"
#include "evolution/evaluation/trials.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>

using namespace cambrian;
using test::CreatureBuilder;
using test::kinds;

namespace {

ExperimentSettings brief() {
    ExperimentSettings settings;
    settings.world.trial.duration = 3.0;
    return settings;
}

// The crawler, with a neuron whose link to a third leg has no weight, and an organ for nobody.
GenomePtr crawler_with_ballast() {
    CreatureBuilder builder(kinds().creature.catalog);
    const auto body = builder.part(0.8, 0.2);
    const auto front = builder.part(0.4, 0.14);
    const auto back = builder.part(0.4, 0.14);
    builder.attach(body, front, 0.12, -1.3);
    builder.attach(body, back, 0.63, 1.3);
    builder.swing(front, 0.7, 0.0, 1.0);
    builder.swing(back, 0.7, 0.25, 1.0);
    const auto useless = builder.neuron(
        back, "oscillate-wave", {CreatureBuilder::constant(1.0), CreatureBuilder::constant(0.0)});
    builder.organ(back, "sound", useless, 1.0);
    return builder.build();
}

Phenotype grown_in(const GenomePtr& genome, const ExperimentSettings& settings) {
    return express(*genome, kinds().creature, settings.expression, settings.world.scene);
}

EvaluationResult judged_with(const GenomePtr& genome, std::vector<Lesion> lesions) {
    const ExperimentSettings settings = brief();
    return evaluate_in_trials(
        {.genome = genome, .trial_seed = trial_seed(settings), .lesions = std::move(lesions)},
        settings, kinds());
}

LesionTable table_of(const GenomePtr& genome, const ExperimentSettings& settings, bool pairs) {
    const auto backend = make_thread_pool_backend(kinds(), 2);
    EvaluationProgress progress;
    const LesionStudy study{.genome = genome, .settings = settings, .worlds = 3, .pairs = pairs};
    auto table = lesion_table(study, kinds(), *backend, progress);
    REQUIRE(table);
    return *table;
}

const LesionRow& row_of(const LesionTable& table, LesionKind kind, std::uint32_t index) {
    const auto found =
        std::find_if(table.rows.begin(), table.rows.end(), [&](const LesionRow& row) {
            return row.lesions.front().kind == kind && row.lesions.front().index == index;
        });
    REQUIRE(found != table.rows.end());
    return *found;
}

}  // namespace

TEST_CASE("no lesion leaves every bit, and each real one changes the motion", "[evolution]") {
    const GenomePtr genome = test::crawler(kinds().creature.catalog);
    const std::uint64_t intact = judged_with(genome, {}).digest;
    CHECK(judged_with(genome, {}).digest == intact);
    for (const Lesion& lesion : lesions_of(grown_in(genome, brief()))) {
        const EvaluationResult result = judged_with(genome, {lesion});
        INFO(words_of(lesion, grown_in(genome, brief()), kinds().creature));
        CHECK(result.outcome == Outcome::kCompleted);
        CHECK(result.digest != intact);
    }
}

TEST_CASE("a lost part takes its muscles, neurons and organs along", "[evolution]") {
    const GenomePtr genome = crawler_with_ballast();
    Phenotype body = grown_in(genome, brief());
    const std::vector<Lesion> both = {{LesionKind::kLostPart, 1}, {LesionKind::kLostPart, 2}};
    Phenotype front_lost = body;
    inflict(std::span(both).first(1), front_lost);
    CHECK(front_lost.parts.size() == 2);
    CHECK(front_lost.plan.parts.size() == 2);
    CHECK(front_lost.parts[1].first_neuron == body.parts[2].first_neuron);
    REQUIRE(front_lost.effectors.size() == 1);
    CHECK(front_lost.effectors[0].part == 1);
    REQUIRE(front_lost.organs.size() == 1);
    CHECK(front_lost.organs[0].part == 1);
    CHECK(front_lost.network.outputs.size() == 2);
    Phenotype torso = body;
    inflict(both, torso);
    CHECK(torso.parts.size() == 1);
    CHECK(torso.effectors.empty());
    CHECK(torso.network.outputs.empty());
}

TEST_CASE("the table names what is vital and what is ballast", "[evolution]") {
    const GenomePtr genome = crawler_with_ballast();
    const LesionTable table = table_of(genome, brief(), true);
    CHECK(table.intact.scores.size() == 3);
    CHECK(table.intact.left == median(table.intact.scores));
    CHECK(table.intact.left > 0.05);
    CHECK(row_of(table, LesionKind::kStillOrgan, 0).left == table.intact.left);
    CHECK(row_of(table, LesionKind::kLockedJoint, 1).left < 0.9 * table.intact.left);
    CHECK(std::is_sorted(table.rows.begin(), table.rows.end(),
                         [](const auto& a, const auto& b) { return a.left < b.left; }));
    CHECK(table.pairs.size() == kPairedLesions * (kPairedLesions - 1) / 2);
    for (const LesionRow& pair : table.pairs)
        CHECK(pair.lesions.size() == 2);
}

TEST_CASE("pruning removes ballast alone, and a pruned creature cannot be pruned", "[evolution]") {
    const ExperimentSettings settings = brief();
    const auto backend = make_thread_pool_backend(kinds(), 2);
    EvaluationProgress progress;
    LesionStudy study{.genome = crawler_with_ballast(), .settings = settings, .worlds = 3};
    const auto twin = pruned(study, kinds(), *backend, progress);
    REQUIRE(twin);
    CHECK(twin->genome->nodes[2].organs.empty());
    CHECK(twin->genome->nodes[2].neurons.size() == 1);
    CHECK(twin->genome->nodes[1].neurons.size() == 1);
    CHECK(twin->after >= 0.997 * twin->before);
    CHECK(validate(*twin->genome, kinds().creature.catalog).empty());
    study.genome = twin->genome;
    CHECK(pruned(study, kinds(), *backend, progress)->removed.empty());
}

TEST_CASE("a stopped study has no table", "[evolution]") {
    const ExperimentSettings settings = brief();
    const auto backend = make_thread_pool_backend(kinds(), 1);
    EvaluationProgress progress;
    std::stop_source stop;
    stop.request_stop();
    const LesionStudy study{.genome = crawler_with_ballast(), .settings = settings};
    CHECK(!lesion_table(study, kinds(), *backend, progress, stop.get_token()));
    CHECK(!pruned(study, kinds(), *backend, progress, stop.get_token()));
}
