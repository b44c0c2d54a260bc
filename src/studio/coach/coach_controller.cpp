#include "studio/coach/coach_controller.h"

#include "core/text/shown_score.h"
#include "genome/creature_name.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {

// Has one overload for each kind of request.
struct CoachController::Handler {
    CoachController& self;

    void operator()(const ChooseFounder& request) const {
        if (self.founders_shown()) self.experiment_.show_founder(request.place);
    }
    void operator()(const ShowSuggestions& request) const { self.suggestions_ = request.shown; }
};

CoachController::CoachController(const Services& services, ViewState& view,
                                 ViewerController& viewer, ExperimentController& experiment)
    : services_(services),
      view_(view),
      viewer_(viewer),
      experiment_(experiment),
      crowd_(services.kinds) {}

void CoachController::carry_out(const CoachRequest& request) {
    std::visit(Handler{*this}, request);
}

CoachView CoachController::facts() const {
    CoachView view;
    view.suggestions = suggestions_;
    if (!founders_shown() || crowd_.founders().empty()) return view;
    view.founders = &crowd_;
    const std::uint64_t shown = viewer_.playback().exhibit().individual().uid;
    const auto& founders = crowd_.founders();
    const auto found =
        std::find_if(founders.begin(), founders.end(),
                     [shown](const IndividualPtr& one) { return one->uid == shown; });
    view.founder = static_cast<std::size_t>(found - founders.begin());
    return view;
}

bool CoachController::founders_shown() const {
    const Playback& playback = viewer_.playback();
    const OpenExperiment& open = experiment_.open();
    return !playback.empty() && playback.exhibit().source == ExhibitSource::kFounder &&
           playback.exhibit().individual().method == "random" && open.begins_at_random() &&
           open.snapshot().history.empty();
}

void CoachController::update(double elapsed) {
    follow_founders(elapsed);
    follow_rivals();
    follow_plateau();
}

void CoachController::follow_founders(double elapsed) {
    if (!founders_shown()) return;
    const EvolutionSnapshot& snapshot = experiment_.open().snapshot();
    // While settings are edited, or are on their way to the engine, the crowd stays.
    const bool settled = *snapshot.settings == experiment_.open().editor().draft();
    if (settled && std::exchange(crowd_of_, snapshot.experiment) != snapshot.experiment) {
        crowd_.show(snapshot.settings);
        services_.feedback.log().write("founders",
                                       {{"count", static_cast<double>(crowd_.founders().size())}});
        // Other settings make other creatures.
        const std::size_t place = facts().founder;
        if (!(viewer_.playback().exhibit().settings() == *snapshot.settings))
            experiment_.show_founder(place < crowd_.founders().size() ? place : 0);
    }
    const Playback::Pace& pace = viewer_.playback().pace();
    crowd_.advance(pace.playing ? elapsed * view_.speed : 0.0);
}

void CoachController::follow_rivals() {
    worker_.deliver();
    const EvolutionSnapshot& snapshot = experiment_.open().snapshot();
    if (std::exchange(raced_, snapshot.experiment) != snapshot.experiment) {
        ahead_ = 0;
        races_ = 0;
        races_from_ = snapshot.champions.size();
    }
    if (!view_.rival || snapshot.champions.empty()) return viewer_.run_beside({});
    const SettingsPtr& settings = snapshot.champions.back().settings;
    if (!rivals_settings_ || !same_judgement(*settings, *rivals_settings_) ||
        !(settings->selection.confirmations == rivals_settings_->selection.confirmations))
        judge_rivals_of(settings);
    if (rivals_judged_) race(snapshot);
    run_along();
}

void CoachController::judge_rivals_of(const SettingsPtr& settings) {
    rivals_settings_ = settings;
    rivals_judged_ = false;
    rivals_.clear();
    ahead_ = 0;
    races_ = 0;
    const GoalKind* goal = services_.kinds.goals.find(settings->goal);
    if (goal == nullptr || goal->is_contest) return;  // its scores depend on the opponents
    worker_.submit([this, settings, folder = samples_folder_,
                    &kinds = services_.kinds](const std::stop_token& stop) {
        auto rivals = judge_rivals(folder, *settings, kinds, stop);
        return [this, settings, rivals = std::move(rivals)]() mutable {
            if (settings != rivals_settings_) return;
            rivals_ = std::move(rivals);
            rivals_judged_ = true;
            services_.feedback.log().write("rivals",
                                           {{"count", static_cast<double>(rivals_.size())}});
        };
    });
}

// Compares the champions that are new with the rivals that were not beaten before. Those of an
// opened experiment are not news.
void CoachController::race(const EvolutionSnapshot& snapshot) {
    for (; races_ < snapshot.champions.size(); ++races_) {
        const JudgedIndividual& champion = snapshot.champions[races_];
        if (!same_judgement(*champion.settings, *rivals_settings_)) continue;
        const double score = champion.individual->result.fitness;
        const std::size_t before = ahead_;
        while (ahead_ < rivals_.size() && score > rivals_[ahead_].score)
            ++ahead_;
        if (ahead_ > before && races_ >= races_from_) celebrate(champion, rivals_[ahead_ - 1]);
    }
}

void CoachController::celebrate(const JudgedIndividual& champion, const JudgedRival& beaten) {
    const std::string unit = goal_unit(champion.settings->goal, services_.kinds.goals);
    const auto shown = [&unit](double score) { return shown_score(score, unit); };
    std::string words =
        fmt::format("Generation {}: {} is ahead of {}, {} against {}.", champion.generation,
                    creature_name(champion.genome()), beaten.name,
                    shown(champion.individual->result.fitness), shown(beaten.score));
    if (ahead_ < rivals_.size()) {
        words += fmt::format(" Its next rival is {}, with {}.", rivals_[ahead_].name,
                             shown(rivals_[ahead_].score));
    } else {
        words += " It is the best known in this world.";
    }
    services_.feedback.log().write("rival beaten", {{"name", beaten.name}});
    services_.feedback.tell(NoticeKind::kFeat, words);
}

// Displays suggestions once in a run, when its best rises no longer (evolution/README.md 3).
void CoachController::follow_plateau() {
    const EvolutionSnapshot& snapshot = experiment_.open().snapshot();
    if (snapshot.history.empty() || !stagnant(snapshot.history.back())) {
        suggestions_ = false;
        return;
    }
    const bool evolved = snapshot.champions.size() > races_from_;
    if (!evolved || std::exchange(advised_, snapshot.experiment) == snapshot.experiment) return;
    suggestions_ = true;
    services_.feedback.log().write(
        "suggestions", {{"generation", static_cast<double>(snapshot.history.back().generation)}});
}

// Lets the next rival run beside the champion on display or, if all are beaten, the best of them.
void CoachController::run_along() {
    if (!rivals_judged_ || rivals_.empty()) return viewer_.run_beside({});
    const JudgedRival& rival = rivals_[std::min(ahead_, rivals_.size() - 1)];
    const std::string unit = goal_unit(rivals_settings_->goal, services_.kinds.goals);
    viewer_.run_beside(Companion{rival.creature,
                                 fmt::format("{}, {}", rival.name, shown_score(rival.score, unit)),
                                 rival.travel});
}

}  // namespace cambrian
