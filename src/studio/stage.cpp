#include "studio/stage.h"

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
    while (!unwanted() && (*trial)->tick()) {
    }
    if (unwanted()) return std::nullopt;
    ScoreReport report;
    report.record = (*trial)->take_record();
    report.unit = goal.unit;
    if (report.record.outcome == Outcome::kCompleted) report.score = goal.score(report.record);
    return report;
}

}  // namespace

Status Stage::show(Exhibit exhibit) {
    if (Status status = playback_.show(std::move(exhibit)); !status) return status;
    score_.reset();
    *outdated_ = true;
    outdated_ = std::make_shared<std::atomic<bool>>(false);
    request_score();
    return {};
}

void Stage::request_score() {
    const GoalKind* goal = kinds_.goals.find(playback_.exhibit().goal);
    if (goal == nullptr) return;
    worker_.submit([this, goal, outdated = outdated_, phenotype = playback_.shared_phenotype(),
                    world = playback_.exhibit().world](const std::stop_token& stop) {
        const auto unwanted = [&] { return stop.stop_requested() || *outdated; };
        auto report = run_and_score(phenotype, kinds_.creature, world, *goal, unwanted);
        return [this, outdated, report = std::move(report)] {
            if (!*outdated && report) score_ = report;
        };
    });
}

}  // namespace cambrian
