// Saving evaluations must not change which creatures survive (evolution/README.md 4).
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evaluation/longest_first.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "evolution/settings/goal_defaults.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"
#include "support/records.h"

using namespace cambrian;
using test::kinds;

namespace {

constexpr int kGenerations = test::by_build(30, 11);

std::shared_ptr<ExperimentSettings> short_walks(int size) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = size;
    settings->population.tuned = 0.0;  // tuned copies of the best have nearly always a chance
    settings->founders.rhythmic_share = 0.0;
    settings->seed = 11;
    settings->world.trial.duration = 5.0;
    return settings;
}

// Walks of creatures that soon move well, long enough to be terminated early.
std::shared_ptr<ExperimentSettings> long_walks() {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 60;
    settings->seed = 11;
    settings->world.trial.duration = 9.0;
    return settings;
}

// The survivors of every generation, and the statistics of what was saved.
struct History {
    std::vector<std::vector<std::uint64_t>> survivors;
    std::vector<GenerationStatistics> statistics;
};

History evolve(const SettingsPtr& settings) {
    const auto backend = make_thread_pool_backend(kinds(), 2);
    Evolution evolution(settings, kinds());
    EvaluationProgress progress;
    History history;
    for (int i = 0; i < kGenerations; ++i) {
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        evolution.breed();
        std::vector<std::uint64_t>& survivors = history.survivors.emplace_back();
        for (const IndividualPtr& one : evolution.population()) {
            if (one->born < evolution.generation()) survivors.push_back(one->genome_hash);
        }
    }
    history.statistics = evolution.history();
    return history;
}

const GoalKind& goal(const char* id) {
    return *kinds().goals.find(id);
}

TrialRecord first_half(TrialRecord record) {
    record.samples.resize(record.samples.size() / 2 + 1);
    return record;
}

}  // namespace

TEST_CASE("stopping at rest changes no survivor, champion or best of any generation",
          "[evolution][savings]") {
    auto settings = short_walks(30);
    const History saved = evolve(settings);
    auto thorough = std::make_shared<ExperimentSettings>(*settings);
    thorough->world.trial.stop_at_rest = false;
    const History full = evolve(thorough);
    int rested = 0;
    for (std::size_t i = 0; i < kGenerations; ++i) {
        CAPTURE(i);
        CHECK(saved.survivors[i] == full.survivors[i]);
        CHECK(saved.statistics[i].best == Approx(full.statistics[i].best).margin(1e-3));
        CHECK(saved.statistics[i].rejected == full.statistics[i].rejected);
        CHECK(saved.statistics[i].reused == full.statistics[i].reused);
        CHECK(full.statistics[i].rested == 0);
        rested += saved.statistics[i].rested;
    }
    CHECK(rested > 0);
    CHECK(saved.statistics[0].time_saved > full.statistics[0].time_saved);
}

// Very few creatures that end early would have survived; from such a generation on runs differ.
TEST_CASE("terminating trials early hardly ever changes a survivor", "[evolution][savings]") {
    auto settings = long_walks();
    SECTION("of swimmers whose lines and plans are limited") {
        settings->goal = "swimming";
        adopt_defaults(*settings, goal("swimming"));
        settings->world.trial.duration = 9.0;
    }
    SECTION("of walkers without limits") {
        settings->selection.line_share = 1.0;
        settings->selection.plan_copies = 0;
    }
    CHECK(settings->terminate_early);  // by default
    const History saved = evolve(settings);
    auto patient = std::make_shared<ExperimentSettings>(*settings);
    patient->terminate_early = false;
    const History full = evolve(patient);
    int given_up = 0;
    int same = 0;
    for (std::size_t i = 0; i < kGenerations; ++i) {
        same += saved.survivors[i] == full.survivors[i] ? 1 : 0;
        given_up += saved.statistics[i].given_up;
        CHECK(saved.statistics[i].best == full.statistics[i].best);
        if (same == static_cast<int>(i) + 1)
            CHECK(saved.statistics[i].evaluations == full.statistics[i].evaluations);
        CHECK(full.statistics[i].given_up == 0);
    }
    CHECK(same >= 0.8 * kGenerations);
    CHECK(given_up > 0);
}

TEST_CASE("a reused score is the one a trial of its own gives", "[evolution][savings]") {
    auto settings = short_walks(40);
    settings->seed = 3;
    const auto backend = make_thread_pool_backend(kinds(), 2);
    Evolution evolution(settings, kinds());
    EvaluationProgress progress;
    int reused = 0;
    for (int i = 0; i < 3; ++i) {
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        reused += evolution.history().back().reused;
        for (const IndividualPtr& one : evolution.population()) {
            const auto fresh = evaluate_in_trials(
                {.genome = one->genome, .trial_seed = trial_seed(*settings)}, *settings, kinds());
            CHECK(fresh.fitness == unconfirmed_score(one->result));
            CHECK(fresh.digest == one->result.digest);
        }
        evolution.breed();
    }
    CHECK(reused > 0);
}

TEST_CASE("what moved steadily could still score more than it did", "[evolution][savings]") {
    for (const char* id : {"walking", "swimming", "jumping"}) {
        for (const double speed : {0.01, 0.2, 1.0}) {
            const TrialRecord record = test::moving_box(
                10.0, 1.0, 0.2, [&](double t) { return Vec3(speed * t, 0.1, 0.0); });
            CAPTURE(id, speed);
            const double score = goal(id).score(record).value;
            CHECK(may_exceed(0.999 * score - 1e-12, first_half(record), goal(id)));
        }
    }
}

TEST_CASE("what never moved can score nothing any more", "[evolution][savings]") {
    const TrialRecord record =
        test::moving_box(10.0, 1.0, 0.2, [](double) { return Vec3(0.0, 0.1, 0.0); });
    for (const char* id : {"walking", "swimming", "jumping"})
        CHECK_FALSE(may_exceed(1e-12, first_half(record), goal(id)));
}

TEST_CASE("a trial without a chance stops early, an audited one goes on and says so",
          "[evolution][savings]") {
    const ExperimentSettings settings;
    const GenomePtr crawler = test::crawler(kinds().creature.catalog);
    const EvaluationResult full = evaluate({.genome = crawler}, settings, kinds());
    const EvaluationResult cut = evaluate(
        {.genome = crawler, .threshold = TerminationThreshold{.score = 1e6}}, settings, kinds());
    CHECK(cut.outcome == Outcome::kStoppedEarly);
    CHECK(cut.terminable);
    CHECK(cut.computed_time == Approx(0.3 * settings.world.trial.duration).margin(0.1));
    CHECK(cut.fitness < 1e6);
    const EvaluationResult audited = evaluate(
        {.genome = crawler, .threshold = TerminationThreshold{.score = 1e6, .audited = true}},
        settings, kinds());
    CHECK(audited.outcome == Outcome::kCompleted);
    CHECK(audited.terminable);
    CHECK(audited.fitness == full.fitness);
    CHECK(audited.digest == full.digest);
    const EvaluationResult promising = evaluate(
        {.genome = crawler, .threshold = TerminationThreshold{.score = 0.0}}, settings, kinds());
    CHECK(promising.digest == full.digest);
    CHECK_FALSE(promising.terminable);
}

TEST_CASE("unknown work is begun first, then the most work, and every trial once",
          "[evolution][savings]") {
    const KindCatalog& catalog = kinds().creature.catalog;
    const GenomePtr large = test::crawler(catalog);
    const GenomePtr small = test::dreamer(catalog);
    const std::vector<EvaluationRequest> requests = {{.genome = large, .expected_work = 5},
                                                     {.genome = small},
                                                     {.genome = small, .expected_work = 90},
                                                     {.genome = large},
                                                     {.genome = small, .expected_work = 5}};
    std::vector<std::size_t> order = {0, 1, 2, 3, 4};
    put_longest_first(order, requests);
    CHECK(order == std::vector<std::size_t>{3, 1, 2, 0, 4});
}

TEST_CASE("until thirty doomed trials were finished, all of them are", "[evolution][savings]") {
    CHECK_FALSE(TerminationAudit{0, 0}.proven());
    CHECK_FALSE(TerminationAudit{29, 0}.proven());
    CHECK(TerminationAudit{30, 0}.proven());
    CHECK_FALSE(TerminationAudit{299, 1}.proven());
    CHECK(TerminationAudit{300, 1}.proven());
    CHECK_FALSE(TerminationAudit{300, 2}.proven());
    const auto settings = long_walks();
    const auto backend = make_thread_pool_backend(kinds(), 2);
    Evolution evolution(settings, kinds());
    EvaluationProgress progress;
    int unproven = 0;
    int given_up = 0;
    for (int i = 0; i < test::by_build(20, 11); ++i) {
        const bool proven = evolution.termination_audit().proven();
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        if (!proven) CHECK(evolution.history().back().given_up == 0);
        unproven += proven ? 0 : 1;
        given_up += evolution.history().back().given_up;
        evolution.breed();
    }
    CHECK(unproven > 1);
    CHECK(given_up > 0);
    CHECK(evolution.termination_audit().finished >= TerminationAudit::kLeastFinished);
}

TEST_CASE("giving up is trusted until 2, and 1 in 1000, audited trials would have survived",
          "[evolution][savings]") {
    CHECK(TerminationAudit{0, 0}.trustworthy());
    CHECK(TerminationAudit{999, 0}.trustworthy());
    CHECK(TerminationAudit{1, 1}.trustworthy());
    CHECK_FALSE(TerminationAudit{1999, 2}.trustworthy());
    CHECK(TerminationAudit{2000, 2}.trustworthy());
}
