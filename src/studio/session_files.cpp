// What a session does with files.

#include "core/pretty_text.h"
#include "studio/panels/generations/timeline_plots.h"
#include "studio/session.h"

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

namespace cambrian {
namespace {

// Words fit for a file name: letters, digits and dashes.
std::string file_stem(const std::string& words) {
    std::string stem;
    for (const char letter : words) {
        const auto byte = static_cast<unsigned char>(letter);
        if (std::isalnum(byte) != 0) {
            stem += static_cast<char>(std::tolower(byte));
        } else if (!stem.empty() && stem.back() != '-') {
            stem += '-';
        }
    }
    while (!stem.empty() && stem.back() == '-')
        stem.pop_back();
    return stem.empty() ? "creature" : stem;
}

}  // namespace

Exhibit Session::exhibit_from(const CreatureDocument& document, ExhibitSource source,
                              const std::filesystem::path& path) const {
    ExperimentSettings settings = experiment_.editor().draft();
    if (document.scored) settings = settings_of(*document.scored);
    Exhibit exhibit;
    exhibit.genome = std::make_shared<const Genome>(document.genome);
    exhibit.world = settings.world;
    exhibit.goal = settings.goal;
    exhibit.expression = settings.expression;
    exhibit.source = source;
    std::string stem = path.filename().string();
    exhibit.title = capitalized(stem.substr(0, stem.find('.')));
    if (!document.genome.name.empty()) exhibit.title = document.genome.name;
    exhibit.seed = settings.seed;
    exhibit.uid = document.uid;
    exhibit.method = document.method;
    exhibit.parents = document.parents;
    exhibit.ancestry = document.ancestry;
    if (document.scored) {
        exhibit.ticks = document.scored->ticks;
        EvaluationResult result;
        result.fitness = document.scored->fitness;
        result.digest = document.scored->trajectory;
        result.finer = document.scored->finer;
        exhibit.result = result;
    }
    return exhibit;
}

CreatureDocument Session::document_on_show() const {
    const Exhibit& exhibit = stage_.playback().exhibit();
    CreatureDocument document;
    document.genome = *exhibit.genome;
    document.uid = exhibit.uid;
    document.parents = exhibit.parents;
    document.method = exhibit.method;
    document.ancestry = exhibit.ancestry;
    const GoalKind* goal = kinds_.goals.find(exhibit.goal);
    const ScoreReport* score = stage_.score();
    // A trial given up is no score to stand by; the one on show is run to its end.
    const bool judged = exhibit.result && exhibit.result->outcome != Outcome::kStoppedEarly;
    if (goal == nullptr || (!judged && score == nullptr)) return document;
    ScoredRecord scored;
    scored.world = exhibit.world;
    if (!judged) scored.world.trial.trials = 1;  // the one on show
    scored.expression = exhibit.expression;
    scored.goal = exhibit.goal;
    scored.seed = exhibit.seed;
    scored.fitness = judged ? exhibit.result->fitness : score->score.value;
    scored.unit = goal->unit;
    scored.trajectory = judged ? exhibit.result->digest : score->record.digest;
    if (judged) {
        scored.finer = exhibit.result->finer;
        scored.ticks = exhibit.ticks;
    }
    document.scored = std::move(scored);
    return document;
}

void Session::remember_in(const std::filesystem::path& folder) {
    memory_ = folder;
    if (folder.empty()) return;
    experiment_.autosave_in(own_experiment(folder));
    std::error_code unknown;
    previous_run_ = std::filesystem::exists(previous_run(own_experiment(folder)), unknown);
}

void Session::reopen_last() {
    if (memory_.empty()) return;
    std::filesystem::path path = kept_.experiment;
    std::error_code unknown;
    if (path.empty()) path = own_experiment(memory_);
    const bool named = !kept_.experiment.empty();
    reopening_ = named || std::filesystem::exists(path, unknown);
    if (reopening_) desk_.load(path);
}

void Session::keep_memory() {
    kept_at_ = now_;
    Remembered present{view_, experiment_.editor().draft(),
                       reopening_ ? kept_.experiment : experiment_.file().string()};
    if (memory_.empty() || present == kept_) return;
    kept_ = present;
    worker_.submit([this, folder = memory_, present = std::move(present)](const std::stop_token&) {
        const Status status = remember(folder, present, kinds_);
        return [this, status] { report(status); };
    });
}

void Session::apply(const OpenFilePanel& action) {
    if (action.task == FileTask::kSaveCreature && stage_.playback().empty()) {
        tell(NoticeKind::kProblem, "There is no creature on show to save.");
        return;
    }
    const bool of_run =
        action.task == FileTask::kSaveStatistics || action.task == FileTask::kSavePlot;
    if (of_run && experiment_.snapshot().history.empty()) {
        tell(NoticeKind::kProblem, "There are no statistics yet; evolve a generation first.");
        return;
    }
    files_.open = true;
    files_.task = action.task;
    ++files_.opened;
    files_.picture = action.picture;
    files_.suggested_name.clear();
    if (action.task == FileTask::kSaveCreature) {
        const Exhibit& exhibit = stage_.playback().exhibit();
        files_.suggested_name = file_stem(exhibit.title) + ".creature.json";
    }
    if (action.task == FileTask::kSaveExperiment) {
        files_.suggested_name = experiment_.file().empty()
                                    ? file_stem(experiment_.editor().draft().goal) + ".cambrian"
                                    : experiment_.file().filename().string();
    }
    if (action.task == FileTask::kSaveSettings) files_.suggested_name = "experiment.toml";
    if (action.task == FileTask::kSaveStatistics) files_.suggested_name = "statistics.csv";
    if (action.task == FileTask::kSavePlot)
        files_.suggested_name = std::string(timeline_plot(view_.quantity).id) + ".png";
    desk_.list(files_.listing.folder, files_.task);
}

void Session::apply(const SaveCreatureFile& action) {
    if (stage_.playback().empty()) return;
    if (!is_card_name(action.path)) return desk_.save_creature(action.path, document_on_show());
    const Exhibit& exhibit = stage_.playback().exhibit();
    CardOrder order{.path = action.path, .document = document_on_show(), .title = exhibit.title};
    order.settings = settings_of(exhibit);
    if (exhibit.experiment != 0) order.generation = exhibit.born;
    desk_.prepare_card(std::move(order));
}

void Session::keep_card(const PreparedCard& card, Image picture) {
    desk_.save_card(card.path, std::move(picture), card.text);
}

void Session::apply(const SaveExperimentFile& action) {
    desk_.save_experiment(action.path, experiment_.kept());
}

// The one before the present one, wherever that is by now.
void Session::apply(const OpenPreviousRun&) {
    const std::filesystem::path own = own_experiment(memory_);
    desk_.load(experiment_.snapshot().history.empty() ? own : previous_run(own));
}

void Session::apply(const SaveSettingsFile& action) {
    desk_.save_settings(action.path, experiment_.editor().draft());
}

void Session::apply(const SaveStatisticsFile& action) {
    desk_.save_statistics(action.path, experiment_.snapshot().history);
}

void Session::keep_picture(const std::filesystem::path& path, Image image) {
    desk_.save_picture(path, std::move(image));
}

void Session::receive(CreatureLoaded& event) {
    view_.newest_champion = false;
    show(exhibit_from(event.document, ExhibitSource::kFile, event.path));
    picking_.show_single(picking_.on());
    log_.write("loaded", {{"path", event.path.string()}});
    std::vector<std::string> warnings = event.document.warnings;
    for (std::string& each :
         foreign_kinds(event.document.genome, experiment_.editor().draft().founders, kinds_))
        warnings.push_back(std::move(each));
    std::string text = "Opened " + event.path.filename().string() + ".";
    if (!warnings.empty()) text += " " + warnings.front();
    if (warnings.size() > 1) text += format(" (%zu more)", warnings.size() - 1);
    tell(NoticeKind::kDone, text);
}

void Session::receive(const SettingsLoaded& event) {
    const Status status = experiment_.replace(event.settings);
    if (!status) return report(status);
    log_.write("loaded", {{"path", event.path.string()}});
    tell(NoticeKind::kDone, "Opened " + event.path.filename().string() +
                                ". Press Evolve to begin with these settings.");
}

void Session::receive(ExperimentLoaded& event) {
    if (std::exchange(reopening_, false) && !experiment_.fresh()) {
        return tell(NoticeKind::kProblem, "The experiment left last time stays in " +
                                              event.path.string() +
                                              "; open it from the File menu.");
    }
    OpenedExperiment& opened = *event.experiment;
    const std::size_t generations = opened.saved.champions.size();
    experiment_.go_on(std::move(opened.saved), std::move(opened.file), event.path);
    stars_.replace(std::move(opened.stars));
    kept_stars_ = stars_.revision();
    picking_.restore(std::move(opened.picking), now_);
    kept_picking_.reset();
    view_.newest_champion = true;
    log_.write("experiment",
               {{"path", event.path.string()}, {"generations", static_cast<double>(generations)}});
    tell(NoticeKind::kDone, "The experiment is where it was left: " + std::to_string(generations) +
                                (generations == 1 ? " generation" : " generations") +
                                ". Press Evolve to go on.");
}

// What was picked by hand goes into the experiment's file as it happens.
void Session::keep_picking() {
    const std::shared_ptr<const PickingSnapshot> picking = picking_.shared_snapshot();
    if (!picking || picking == kept_picking_ || picking->tree.empty()) return;
    kept_picking_ = picking;
    worker_.submit([this, picking, kept = experiment_.kept()](const std::stop_token&) {
        const Status status = kept->keep_picking({picking->tree, picking->picks, picking->shelf});
        return [this, status] { report(status); };
    });
}

void Session::keep_stars() {
    if (stars_.revision() == kept_stars_) return;
    kept_stars_ = stars_.revision();
    worker_.submit([this, stars = stars_.all(), kept = experiment_.kept()](const std::stop_token&) {
        const Status status = kept->keep_stars(stars);
        return [this, status] { report(status); };
    });
}

void Session::receive(const FileSaved& event) {
    log_.write("saved", {{"path", event.path.string()}});
    if (event.path.extension() == ".cambrian") experiment_.moved_to(event.path);
    if (picking_.on() && event.creature) picking_.send(NoteSave{}, now_);
    tell(NoticeKind::kDone, "Saved " + event.path.string());
}

void Session::receive(const FileFailed& event) {
    reopening_ = false;
    log_.write("failed", {{"path", event.path.string()}});
    tell(NoticeKind::kProblem, event.message);
}

}  // namespace cambrian
