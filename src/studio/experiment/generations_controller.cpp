#include "studio/experiment/generations_controller.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLeastStay = 5.0;  // s; shortest time for which a champion is displayed

}  // namespace

// Has one overload for each kind of request.
struct GenerationsController::Handler {
    GenerationsController& self;

    void operator()(const ShowChampion& request) const {
        self.view_.newest_champion = false;
        const JudgedIndividual* champion = self.champion_of(request.generation);
        if (champion == nullptr) return;
        const Playback& playback = self.viewer_.playback();
        const bool shown = !playback.empty() &&
                           playback.exhibit().source == ExhibitSource::kChampion &&
                           playback.exhibit().creature.generation == request.generation &&
                           playback.exhibit().genome() == champion->individual->genome;
        if (!shown) self.show_champion(*champion);
    }
    void operator()(const ShowIndividual& request) const {
        self.view_.newest_champion = false;
        const JudgedIndividual& creature = request.creature;
        Exhibit exhibit = exhibit_of(creature, ExhibitSource::kPopulation);
        const JudgedIndividual* contemporary = self.champion_of(creature.generation);
        if (contemporary != nullptr && contemporary->settings == creature.settings)
            exhibit.experiment = self.experiment_.open().snapshot().experiment;
        self.viewer_.show(std::move(exhibit));
    }
    void operator()(const ShowNewest&) const {
        self.view_.newest_champion = true;
        const auto& champions = self.experiment_.open().snapshot().champions;
        if (!champions.empty()) self.show_champion(champions.back());
    }
    void operator()(const ToggleStar& request) const {
        self.stars_.toggle(request.creature);
        const Individual& individual = *request.creature.individual;
        self.services_.feedback.log().write(self.stars_.has(individual) ? "starred" : "star taken",
                                            {{"uid", uid_text(individual.uid)}});
    }
    void operator()(const ToggleStarOfShown&) const {
        if (const auto creature = self.creature_on_display()) return (*this)(ToggleStar{*creature});
        self.services_.feedback.tell(
            NoticeKind::kProblem,
            "Only creatures of this experiment can have a star; save this one to keep it.");
    }
    void operator()(const RestoreStar&) const { self.stars_.restore(); }
};

void GenerationsController::carry_out(const GenerationsRequest& request) {
    std::visit(Handler{*this}, request);
}

void GenerationsController::log_finished() {
    const EvolutionSnapshot& snapshot = experiment_.open().snapshot();
    if (snapshot.experiment != seen_experiment_) {
        seen_experiment_ = snapshot.experiment;
        seen_rows_ = 0;
    }
    for (std::size_t i = seen_rows_; i < snapshot.history.size(); ++i) {
        const GenerationStatistics& row = snapshot.history[i];
        services_.feedback.log().write(
            "generation", {{"number", static_cast<double>(row.generation)}, {"best", row.best}});
    }
    seen_rows_ = snapshot.history.size();
}

// Displays the newest champion once the one before was displayed for kLeastStay; the first one at
// once.
void GenerationsController::follow_newest() {
    const EvolutionSnapshot& snapshot = experiment_.open().snapshot();
    const Playback& playback = viewer_.playback();
    if (!view_.newest_champion || snapshot.champions.empty() || viewer_.held()) return;
    const JudgedIndividual& newest = snapshot.champions.back();
    const bool first = playback.empty() || playback.exhibit().source != ExhibitSource::kChampion;
    const bool same = !first && playback.exhibit().genome() == newest.individual->genome;
    if (!same && (first || viewer_.shown_for() > kLeastStay)) show_champion(newest);
}

void GenerationsController::follow_audit() {
    const Playback& playback = viewer_.playback();
    if (playback.empty() || playback.exhibit().source != ExhibitSource::kChampion ||
        playback.exhibit().experiment != experiment_.open().snapshot().experiment)
        return;
    const JudgedIndividual& shown = playback.exhibit().creature;
    const JudgedIndividual* champion = champion_of(shown.generation);
    if (champion != nullptr && champion->individual != shown.individual &&
        champion->individual->genome == shown.individual->genome)
        viewer_.rejudge(champion->individual);
}

void GenerationsController::keep_stars() {
    const unsigned run = experiment_.open().runs_begun();
    if (std::exchange(starred_run_, run) != run) replace_stars({});
    if (stars_.revision() == kept_stars_) return;
    kept_stars_ = stars_.revision();
    write_in_background(services_,
                        [stars = stars_.all(), kept = experiment_.open().files().kept()] {
                            return kept->keep_stars(stars);
                        });
}

void GenerationsController::replace_stars(std::vector<JudgedIndividual> stars) {
    stars_.replace(std::move(stars));
    kept_stars_ = stars_.revision();
    starred_run_ = experiment_.open().runs_begun();
}

void GenerationsController::show_champion(const JudgedIndividual& champion) {
    Exhibit exhibit = exhibit_of(champion, ExhibitSource::kChampion);
    exhibit.experiment = experiment_.open().snapshot().experiment;
    viewer_.show(std::move(exhibit));
}

const JudgedIndividual* GenerationsController::champion_of(std::uint32_t generation) const {
    const auto& champions = experiment_.open().snapshot().champions;
    const auto found = std::lower_bound(champions.begin(), champions.end(), generation,
                                        [](const JudgedIndividual& each, std::uint32_t wanted) {
                                            return each.generation < wanted;
                                        });
    const bool known = found != champions.end() && found->generation == generation;
    return known ? &*found : nullptr;
}

// Returns nothing if the displayed creature has no star and belongs to no generation of this
// experiment.
std::optional<JudgedIndividual> GenerationsController::creature_on_display() const {
    if (viewer_.playback().empty()) return std::nullopt;
    const Exhibit& exhibit = viewer_.playback().exhibit();
    for (const JudgedIndividual& starred : stars_.all()) {
        if (starred.individual->genome == exhibit.genome()) return starred;
    }
    const JudgedIndividual* champion = champion_of(exhibit.creature.generation);
    if (champion == nullptr) return std::nullopt;
    if (champion->individual->genome == exhibit.genome()) return *champion;
    for (const IndividualPtr& individual : experiment_.open().snapshot().population) {
        if (individual->genome == exhibit.genome())
            return JudgedIndividual{exhibit.creature.generation, individual, champion->settings};
    }
    return std::nullopt;
}

}  // namespace cambrian
