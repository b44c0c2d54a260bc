#include "studio/stage.h"

#include <functional>
#include <stop_token>
#include <utility>

namespace cambrian {
namespace {

std::optional<ScoreReport> run_and_score(std::shared_ptr<const Phenotype> phenotype,
                                         const Kinds& kinds, const TrialWorld& world,
                                         const GoalKind& goal,
                                         const std::function<bool()>& stopped) {
    auto trial = Trial::start(std::move(phenotype), kinds, world);
    if (!trial) return std::nullopt;
    while (!stopped() && (*trial)->tick()) {
    }
    if (stopped()) return std::nullopt;
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
    ++shown_;
    outdated_.request_stop();
    outdated_ = {};
    request_score();
    return {};
}

void Stage::request_score() {
    const GoalKind* goal = kinds_.goals.find(playback_.exhibit().goal);
    if (goal == nullptr) return;
    worker_.submit([this, goal, shown = shown_, outdated = outdated_.get_token(),
                    phenotype = playback_.shared_phenotype(),
                    world = playback_.exhibit().world](const std::stop_token& stop) {
        const auto stopped = [&] { return stop.stop_requested() || outdated.stop_requested(); };
        if (stopped()) return BackgroundWorker::Completion([] {});
        auto report = run_and_score(phenotype, kinds_.creature, world, *goal, stopped);
        return BackgroundWorker::Completion([this, shown, report = std::move(report)] {
            if (shown == shown_ && report) score_ = report;
        });
    });
}

}  // namespace cambrian
