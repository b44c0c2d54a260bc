#include "studio/comparison/comparison_controller.h"

#include "core/hash.h"
#include "core/text/counted.h"
#include "goals/goal.h"
#include "persist/settings/settings_file.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <utility>
#include <variant>

namespace cambrian {
namespace {

// Returns the name of the comparison's folder. The same settings give the same name, so that a
// comparison that was stopped is found again.
std::string folder_name(const ComparisonDraft& draft, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds) {
    Hash64 hash;
    hash.add(digested_settings(settings, kinds));
    hash.add(draft.varied);
    const std::string varied = draft.varied.empty() ? "as-set" : draft.varied;
    return fmt::format("{}-{}-{}", settings.goal, varied, hex_text(hash.value()).substr(0, 8));
}

std::vector<std::string> arms_of_plan(const ComparisonPlan& plan) {
    std::vector<std::string> names;
    for (const NamedSettings& arm : plan.arms)
        names.push_back(arm.name);
    if (plan.random_search) names.emplace_back(kRandomSearch);
    return names;
}

}  // namespace

// Has one overload for each kind of request.
struct ComparisonController::Handler {
    ComparisonController& self;

    void operator()(const ToggleComparison&) const {
        self.facts_.card_open = !self.facts_.card_open;
    }
    void operator()(const EditComparison& request) const {
        self.facts_.draft = request.draft;
        self.facts_.problem.clear();
    }
    void operator()(const BeginComparison&) const { self.begin(); }
    void operator()(const StopComparison&) const {
        if (self.running_) self.running_->stop();
    }
};

ComparisonController::ComparisonController(const Services& services,
                                           const ExperimentController& experiment,
                                           const ThreadShare& threads)
    : services_(services), experiment_(experiment), threads_(threads) {}

void ComparisonController::carry_out(const ComparisonRequest& request) {
    std::visit(Handler{*this}, request);
}

Result<RunningComparison::Job> ComparisonController::job() const {
    if (folder_.empty()) return Error{"this window has no folder in which runs are kept"};
    const ExperimentSettings& settings = experiment_.open().editor().draft();
    auto plan = plan_of(facts_.draft, settings, services_.kinds);
    if (!plan) return plan.error();
    plan->museum = museum_;
    auto runs = planned_runs(*plan, services_.kinds);
    if (!runs) return runs.error();
    return RunningComparison::Job{
        .runs = *std::move(runs),
        .arms = arms_of_plan(*plan),
        .folder = folder_ / "comparisons" / folder_name(facts_.draft, settings, services_.kinds),
        .threads = threads_};
}

void ComparisonController::begin() {
    if (running_) return;
    auto planned = job();
    facts_.problem.clear();
    if (!planned) {
        facts_.problem = planned.error().message;
        return;
    }
    facts_.results = nullptr;
    facts_.folder = planned->folder.string();
    facts_.unit = goal_unit(experiment_.open().editor().draft().goal, services_.kinds.goals);
    facts_.share = 0.0;
    facts_.running = true;
    services_.feedback.log().write("comparison begun",
                                   {{"runs", static_cast<double>(planned->runs.size())}});
    running_ = std::make_unique<RunningComparison>(*std::move(planned), services_.kinds);
}

void ComparisonController::update() {
    if (!running_) return;
    facts_.share = running_->share();
    facts_.results = running_->latest();
    if (facts_.results != nullptr && facts_.results->ended) end();
}

void ComparisonController::end() {
    running_.reset();
    const ComparisonResults& results = *facts_.results;
    facts_.running = false;
    facts_.problem = results.problem;
    services_.feedback.log().write("comparison ended",
                                   {{"runs", static_cast<double>(results.finished())}});
    if (facts_.card_open) return;
    if (!results.problem.empty()) {
        services_.feedback.tell(NoticeKind::kProblem, "The comparison ended: " + results.problem);
    } else if (results.finished() == results.planned_runs()) {
        services_.feedback.tell(NoticeKind::kDone,
                                fmt::format("The comparison of {} is finished. File > Compare "
                                            "settings shows it.",
                                            counted(results.finished(), "run")));
    }
}

}  // namespace cambrian
