#include "studio/files/files_controller.h"

#include "core/text/counted.h"
#include "evolution/evaluation/trials.h"
#include "persist/experiment/file_dimensions.h"
#include "persist/page/run_page.h"
#include "persist/settings/challenge_file.h"
#include "pictures/film.h"
#include "pictures/race.h"
#include "studio/background/people_words.h"
#include "studio/files/creature_exhibit.h"
#include "studio/files/saved_movies.h"
#include "studio/files/saved_pages.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

// Example: "Opened wanderer.creature.json. The first warning (2 more)".
std::string opened_words(const std::filesystem::path& path,
                         const std::vector<std::string>& warnings) {
    std::string text = fmt::format("Opened {}.", path.filename().string());
    if (!warnings.empty()) text += " " + people_words(warnings.front());
    if (warnings.size() > 1) text += fmt::format(" ({} more)", warnings.size() - 1);
    return text;
}

std::string words_of_settings(const SettingsLoaded& event) {
    const std::string name = event.path.filename().string();
    if (!name.ends_with(kChallengeEnding))
        return fmt::format("Opened {}. Press Evolve to begin with these settings.", name);
    return fmt::format("The challenge {}: {} trials with seed {}. Press Evolve to begin.",
                       name.substr(0, name.size() - kChallengeEnding.size()),
                       event.settings.max_evaluations, event.settings.seed);
}

// Says what failed, where, and what can be done about it.
std::string failure_words(const FileFailed& event) {
    std::string words = people_words(event.message);
    if (!event.reading) return words;
    if (!words.empty() && words.back() != '.') words += '.';
    return words + " Nothing was opened: mend the file there, or open another one (Ctrl+O).";
}

// Example: "Champions of walking, seed 7".
std::string run_title(const EvolutionSnapshot& run) {
    return fmt::format("Champions of {}, seed {}", run.settings->goal, run.settings->seed);
}

}  // namespace

// Has one overload for each kind of request.
struct FilesController::Handler {
    FilesController& self;

    void operator()(const OpenFilePanel& request) const {
        if (!self.may_open(request.task)) return;
        FileBrowser& browser = self.browser_;
        browser.open = true;
        browser.task = request.task;
        ++browser.opened;
        browser.picture = request.picture;
        browser.own_file = request.task == FileTask::kSaveExperiment
                               ? self.subjects_.experiment.open().files().chosen()
                               : std::filesystem::path();
        const std::string name = self.suggested_name(request.task);
        browser.suggested_name = browser.own_file.empty() ? free_name(browser.listing.folder, name,
                                                                      ending_of(request.task))
                                                          : name;
        self.file_service_.list(browser.listing.folder, browser.task);
    }
    void operator()(const CloseFilePanel&) const { self.browser_.open = false; }
    void operator()(const ListFolder& request) const {
        self.file_service_.list(request.folder, self.browser_.task);
    }
    void operator()(const LoadFile& request) const {
        self.start_.open = false;
        self.file_service_.load(request.path);
    }
    void operator()(const SaveCreatureFile& request) const {
        if (self.subjects_.viewer.playback().empty()) return;
        if (is_page_path(request.path)) return self.write_page(request.path);
        CreatureDocument document = self.displayed_document();
        if (!is_card_name(request.path))
            return self.file_service_.save_creature(request.path, std::move(document));
        const Exhibit& exhibit = self.subjects_.viewer.playback().exhibit();
        CardOrder order{.path = request.path,
                        .document = std::move(document),
                        .title = exhibit.name(),
                        .settings = exhibit.settings()};
        if (exhibit.experiment != 0) order.generation = exhibit.creature.generation;
        self.file_service_.prepare_card(std::move(order));
    }
    void operator()(const SaveCell& request) const {
        if (self.subjects_.picking.show_cell(request.cell))
            (*this)(OpenFilePanel{FileTask::kSaveCreature});
    }
    void operator()(const SaveResident&) const { save_alone(WorldSubject::kPicked); }
    void operator()(const SavePiece&) const { save_alone(WorldSubject::kPiece); }
    void save_alone(WorldSubject subject) const {
        if (self.subjects_.preserve.show_alone(subject))
            (*this)(OpenFilePanel{FileTask::kSaveCreature});
    }
    void operator()(const SavePreserveFile& request) const {
        self.subjects_.preserve.move_to(request.path);
    }
    void operator()(const SaveExperimentFile& request) const {
        self.file_service_.save_experiment(request.path,
                                           self.subjects_.experiment.open().files().kept());
    }
    void operator()(const OpenPreviousRun&) const {
        const std::filesystem::path before = self.subjects_.experiment.open().files().before();
        if (!before.empty()) self.file_service_.load(before);
    }
    void operator()(const SaveSettingsFile& request) const {
        self.file_service_.save_settings(request.path,
                                         self.subjects_.experiment.open().editor().draft());
    }
    void operator()(const SaveStatisticsFile& request) const {
        self.file_service_.save_statistics(request.path,
                                           self.subjects_.experiment.open().snapshot().history);
    }
    void operator()(const SavePlotPicture& request) const { self.orders_.plot = request; }
    void operator()(const SaveScreenshot& request) const { self.orders_.screenshot = request; }
    void operator()(const SaveClip& request) const {
        if (self.subjects_.viewer.playback().empty()) return;
        const Exhibit& exhibit = self.subjects_.viewer.playback().exhibit();
        TrialClip clip{request.path,
                       self.displayed_document(),
                       exhibit.name(),
                       exhibit.settings(),
                       request.choice,
                       palette_of(self.view_.theme),
                       {}};
        if (exhibit.experiment != 0) clip.generation = exhibit.creature.generation;
        self.long_files_.write(
            request.path, request.choice.seconds,
            [clip = std::move(clip), &kinds = self.services_.kinds](
                const TrialWatch& watch) mutable { return write_trial_clip(clip, kinds, watch); });
    }
    void operator()(const SaveSeen&) const { self.orders_.seen = true; }
    void operator()(const SaveRunPage& request) const {
        const OpenExperiment& experiment = self.subjects_.experiment.open();
        const RunPage page{request.path, experiment.files().kept(),
                           run_title(experiment.snapshot())};
        self.long_files_.write(
            request.path, static_cast<double>(kPageChampions),
            [page, parts = self.page_parts_, &kinds = self.services_.kinds](
                const TrialWatch& watch) { return write_run_page(page, parts, kinds, watch); });
    }
    void operator()(const SaveFilm& request) const {
        const OpenExperiment& experiment = self.subjects_.experiment.open();
        const double trial = experiment.snapshot().settings->world.trial.duration;
        const double each = std::min(request.choice.seconds, trial) / request.choice.speed;
        const RunFilm film{request.path, experiment.files().kept(), request.choice,
                           palette_of(self.view_.theme)};
        self.long_files_.write(request.path, static_cast<double>(kFilmScenes) * each,
                               [film, &kinds = self.services_.kinds](const TrialWatch& watch) {
                                   return write_run_film(film, kinds, watch);
                               });
    }
    void operator()(const SaveRace& request) const {
        if (!self.may_open(FileTask::kSaveRace)) return;
        const std::vector<JudgedIndividual>& stars = self.subjects_.generations.facts().stars.all();
        const Playback& playback = self.subjects_.viewer.playback();
        const CreatureRace race{
            request.path, stars,
            playback.empty() ? *stars.front().settings : playback.exhibit().settings(),
            request.choice, palette_of(self.view_.theme)};
        const double length = std::min(request.choice.seconds, race.settings.world.trial.duration) /
                              request.choice.speed;
        self.long_files_.write(request.path, length,
                               [race, &kinds = self.services_.kinds](const TrialWatch& watch) {
                                   return write_creature_race(race, kinds, watch);
                               });
    }
    void operator()(const StopFile&) const { self.long_files_.stop(); }
    void operator()(const CopyPicture&) const { self.orders_.copy = true; }
    void operator()(const WatchSample& request) const { self.watch_sample(request.path); }
    // The folder is read each time, so that creatures added meanwhile are found.
    void operator()(const ToggleSamples&) const {
        self.samples_.open = !self.samples_.open;
        self.watch_sample({});
        if (self.samples_.open) self.read_sample_folder();
    }
    void operator()(const ToggleStartPage&) const {
        self.start_.open = !self.start_.open;
        self.watch_sample({});
        if (!self.start_.open) return;
        self.read_runs();
        self.read_sample_folder();
    }
    void operator()(const OpenRun& request) const {
        self.start_.open = false;
        if (request.path != self.subjects_.experiment.open().files().chosen())
            self.file_service_.load(request.path);
    }
    void operator()(const BeginElsewhere&) const {
        if (self.services_.elsewhere != nullptr) self.crossing_ = SpaceCrossing{};
    }
    void operator()(const ForgetRun& request) const {
        std::erase(self.start_.paths, request.path);
        std::erase_if(self.start_.runs,
                      [&request](const RecentRun& run) { return run.path == request.path; });
    }
};

// Has one overload for each result of reading or writing.
struct FilesController::Receiver {
    FilesController& self;

    Feedback& feedback() const { return self.services_.feedback; }
    void log(const char* event, const std::filesystem::path& path) const {
        feedback().log().write(event, {{"path", path.string()}});
    }

    // A creature that is opened while the preserve is displayed joins it.
    void operator()(const CreatureLoaded& event) const {
        if (self.subjects_.preserve.world_shown()) {
            log("loaded", event.path);
            return self.subjects_.preserve.add(event.document.creature.individual->genome);
        }
        self.view_.newest_champion = false;
        self.show(event.document, ExhibitSource::kFile, event.path);
        self.subjects_.picking.yield_viewport();
        log("loaded", event.path);
        std::vector<std::string> warnings = event.document.warnings;
        const ExperimentSettings& draft = self.subjects_.experiment.open().editor().draft();
        for (std::string& each :
             foreign_kinds(event.document.genome(), draft.founders, self.services_.kinds))
            warnings.push_back(std::move(each));
        feedback().tell(NoticeKind::kDone, opened_words(event.path, warnings));
    }
    void operator()(const SettingsLoaded& event) const {
        const Status status = self.subjects_.experiment.open().replace(event.settings);
        if (!status) return feedback().report(status);
        self.view_.newest_champion = false;  // that of the run before
        self.subjects_.experiment.show_founder(0);
        log("loaded", event.path);
        feedback().tell(NoticeKind::kDone, words_of_settings(event));
    }
    void operator()(const PreserveSettingsLoaded& event) const {
        log("loaded", event.path);
        self.subjects_.preserve.carry_out(
            PlanPreserve{event.path, event.settings.world.environment.has_ground});
    }
    void operator()(ExperimentLoaded& event) const {
        OpenExperiment& experiment = self.subjects_.experiment.open();
        const bool reopened = std::exchange(self.reopening_, false);
        if (reopened && !experiment.fresh()) {
            return feedback().tell(
                NoticeKind::kProblem,
                fmt::format(
                    "The experiment left last time stays in {}; open it from the File menu.",
                    event.path.string()));
        }
        self.subjects_.preserve.carry_out(ClosePreserve{});
        if (!reopened) use_run(self.start_.paths, event.path);
        OpenedExperiment& opened = *event.experiment;
        const std::size_t generations = opened.saved.champions.size();
        experiment.go_on(std::move(opened.saved), std::move(opened.file), event.path);
        self.subjects_.generations.replace_stars(std::move(opened.stars));
        self.subjects_.picking.restore(std::move(opened.picking));
        self.view_.newest_champion = true;
        feedback().log().write("experiment", {{"path", event.path.string()},
                                              {"generations", static_cast<double>(generations)}});
        // A loss is more important news than that the rest is there.
        const Notice* present = feedback().notice();
        if (reopened && present != nullptr && present->kind == NoticeKind::kProblem) return;
        feedback().tell(
            NoticeKind::kDone,
            fmt::format("The experiment is where it was left: {}. Press Evolve to go on.",
                        counted(generations, "generation")));
    }
    void operator()(PreserveLoaded& event) const {
        if (!std::exchange(self.reopening_, false)) use_run(self.start_.paths, event.path);
        self.subjects_.preserve.open(std::move(*event.world));
        log("loaded", event.path);
    }
    void operator()(const FileElsewhere& event) const {
        self.reopening_ = false;
        if (self.services_.elsewhere != nullptr) self.crossing_ = SpaceCrossing{event.path};
    }
    void operator()(const FileSaved& event) const {
        log("saved", event.path);
        ++self.saves_;
        if (event.path.extension() == ".cambrian") {  // an experiment
            self.subjects_.experiment.open().files().moved_to(event.path);
            use_run(self.start_.paths, event.path);
        }
        feedback().tell(NoticeKind::kDone, "Saved " + event.path.string());
    }
    void operator()(CardPrepared& event) const { self.orders_.card = std::move(event.card); }
    void operator()(FolderListed& event) const { self.browser_.listing = std::move(event.listing); }
    void operator()(const FileFailed& event) const {
        self.reopening_ = false;
        log("failed", event.path);
        feedback().tell(NoticeKind::kProblem, failure_words(event));
    }
};

FilesController::FilesController(const Services& services, ViewState& view,
                                 const FileSubjects& subjects)
    : services_(services),
      view_(view),
      subjects_(subjects),
      file_service_(services.worker, services.kinds, services.elsewhere) {
    browser_.listing.folder = std::filesystem::current_path();
}

void FilesController::watch_sample(const std::filesystem::path& path) {
    samples_.watched = path;
    samples_.motion = nullptr;
    sample_motion_.reset();
    const auto sample =
        std::find_if(samples_.samples.begin(), samples_.samples.end(),
                     [&](const Sample& each) { return each.path == path && each.phenotype; });
    if (sample == samples_.samples.end()) return;
    const ExperimentSettings& settings = *sample->creature.settings;
    sample_motion_.emplace(sample->kinds->creature);
    sample_motion_->show({sample->creature.individual}, settings.expression,
                         first_trial_world(settings));
    samples_.motion = &*sample_motion_;
}

void FilesController::update(double elapsed) {
    if (sample_motion_) sample_motion_->advance(elapsed);
    for (FileEvent& event : file_service_.take_events())
        std::visit(Receiver{*this}, event);
    tell_finished_files();
}

void FilesController::write_page(const std::filesystem::path& path) {
    CreaturePage page{path, displayed_document(), subjects_.viewer.playback().exhibit().name()};
    long_files_.write(
        path, 1.0,
        [page = std::move(page), parts = page_parts_, &kinds = services_.kinds](
            const TrialWatch& watch) { return write_creature_page(page, parts, kinds, watch); });
}

void FilesController::tell_finished_files() {
    const Receiver receiver{*this};
    for (const FinishedFile& file : long_files_.take_finished()) {
        if (file.status) {
            receiver(FileSaved{file.path});
        } else if (file.stopped) {
            receiver.log("stopped", file.path);
            services_.feedback.tell(
                NoticeKind::kDone, fmt::format("{} was not saved.", file.path.filename().string()));
        } else {
            receiver(FileFailed{file.path, file.status.error().message});
        }
    }
}

void FilesController::carry_out(const FilesRequest& request) {
    std::visit(Handler{*this}, request);
}

void FilesController::read_sample_folder() {
    services_.worker.submit([this, folders = sample_folders_, museum = museum_,
                             services = services_](const std::stop_token&) {
        auto found = read_sample_folders(folders, museum, services.kinds, services.elsewhere);
        return [this, found = std::move(found)] {
            samples_.samples = found;
            samples_.read = true;
            services_.feedback.log().write("samples",
                                           {{"count", static_cast<double>(found.size())}});
        };
    });
}

// Each run is a job of its own, so that a large one does not keep other files waiting.
void FilesController::read_runs() {
    start_.read = false;
    start_.runs.clear();
    for (const std::filesystem::path& path : start_.paths) {
        services_.worker.submit([this, path, services = services_](const std::stop_token&) {
            const EvolutionKinds& kinds = services.kinds_in(dimensions_of_file(path));
            return [this, run = read_run(path, kinds)] { start_.runs.push_back(run); };
        });
    }
    services_.worker.submit([this, folder = challenges_folder_](const std::stop_token&) {
        return [this, found = challenges_in(folder)] {
            start_.challenges = found;
            start_.read = true;
            services_.feedback.log().write("start page",
                                           {{"runs", static_cast<double>(start_.runs.size())}});
        };
    });
}

void FilesController::open_now(const std::filesystem::path& path, ExhibitSource source) {
    FileEvent event = load_file(path, services_.kinds, services_.elsewhere);
    auto* creature = std::get_if<CreatureLoaded>(&event);
    if (creature == nullptr) return std::visit(Receiver{*this}, event);
    show(creature->document, source, path);
    if (source == ExhibitSource::kFile)
        services_.feedback.log().write("loaded", {{"path", path.string()}});
}

void FilesController::reopen(const std::filesystem::path& path) {
    reopening_ = true;
    file_service_.load(path);
}

void FilesController::save_card(const PreparedCard& card, Image picture) {
    file_service_.save_card(card.path, std::move(picture), card.text);
}

void FilesController::save_picture(const std::filesystem::path& path, Image image) {
    file_service_.save_picture(path, std::move(image));
}

void FilesController::save_seen(const std::filesystem::path& path, SeenClip seen) {
    const double length = seen.end - seen.pictures.front().time;
    long_files_.write(
        path, length,
        [path, format = clip_format_of(path), seen = std::move(seen)](const TrialWatch& watch) {
            return write_seen_clip(seen, *format, path, watch);
        });
}

void FilesController::want_samples() {
    if (!samples_.read) read_sample_folder();
}

void FilesController::show(const CreatureDocument& document, ExhibitSource source,
                           const std::filesystem::path& path) {
    const ExperimentSettings& draft = subjects_.experiment.open().editor().draft();
    subjects_.viewer.show(exhibit_of(document, draft, source, path));
}

CreatureDocument FilesController::displayed_document() const {
    return document_of(subjects_.viewer.playback().exhibit(), subjects_.viewer.score(),
                       services_.kinds);
}

}  // namespace cambrian
