#include "studio/viewer/viewer.h"

#include "evolution/evaluation/trials.h"

#include <functional>
#include <stop_token>
#include <utility>

namespace cambrian {
namespace {

template <class Unwanted>
std::optional<ScoreReport> run_and_score(std::shared_ptr<const Phenotype> phenotype,
                                         const Kinds& kinds, const TrialWorld& world,
                                         const GoalKind& goal, const Unwanted& unwanted) {
    if (unwanted()) return std::nullopt;
    auto trial = Trial::start(std::move(phenotype), kinds, world);
    if (!trial) return std::nullopt;
    ScoreReport report;
    if (!run_noting_ticks(**trial, report.ticks, unwanted)) return std::nullopt;
    report.record = (*trial)->take_record();
    report.unit = goal.unit;
    report.digest = report.record.digest;
    if (report.record.outcome == Outcome::kCompleted) report.score = goal.score(report.record);
    return report;
}

std::optional<ScoreReport> report_on(const Exhibit& exhibit,
                                     std::shared_ptr<const Phenotype> phenotype,
                                     const GoalKind& goal, const EvolutionKinds& kinds,
                                     const std::stop_token& stop,
                                     const std::atomic<bool>& outdated) {
    const auto unwanted = [&] { return stop.stop_requested() || outdated; };
    auto report = run_and_score(std::move(phenotype), kinds.creature,
                                first_trial_world(exhibit.settings()), goal, unwanted);
    if (!report || exhibit.settings().world.trial.trials == 1) return report;
    const ExperimentSettings& settings = exhibit.settings();
    const EvaluationRequest request{.genome = exhibit.genome(), .trial_seed = trial_seed(settings)};
    report->digest = evaluate_in_trials(request, settings, kinds, stop).digest;
    return report;
}

}  // namespace

Status Viewer::show(Exhibit exhibit) {
    if (Status status = playback_.show(std::move(exhibit)); !status) return status;
    score_.reset();
    *outdated_ = true;
    outdated_ = std::make_shared<std::atomic<bool>>(false);
    request_score();
    return {};
}

void Viewer::request_score() {
    const GoalKind* goal = kinds_.goals.find(playback_.exhibit().settings().goal);
    if (goal == nullptr) return;
    worker_.submit([this, goal, outdated = outdated_,
                    phenotype = playback_.creature().shared_phenotype(),
                    exhibit = playback_.exhibit()](const std::stop_token& stop) {
        auto report = report_on(exhibit, phenotype, *goal, kinds_, stop, *outdated);
        return [this, outdated, report = std::move(report)] {
            if (!*outdated && report) score_ = report;
        };
    });
}

}  // namespace cambrian
