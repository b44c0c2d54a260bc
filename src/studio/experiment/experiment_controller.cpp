#include "studio/experiment/experiment_controller.h"

#include "evolution/generation.h"
#include "evolution/settings/goal_defaults.h"
#include "picking/handover.h"
#include "sketch/strokes.h"
#include "studio/experiment/setting_groups.h"
#include "world/ground_stroke.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {

namespace {

void replace_first(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at != std::string::npos) text.replace(at, from.size(), to);
}

// Returns a message with the settings' labels, as the panel shows them, in place of their names in
// files: "“Shortest part”: 1.6 is above “Longest part”, which is 0.08".
std::string with_labels(std::string message, const std::vector<SettingField>& fields) {
    const auto subject = std::find_if(fields.begin(), fields.end(), [&](const SettingField& each) {
        return message.starts_with(fmt::format("[{}] {}:", each.table, each.key));
    });
    if (subject == fields.end()) return message;
    replace_first(message, fmt::format("[{}] {}", subject->table, subject->key),
                  fmt::format("“{}”", subject->label));
    for (const SettingField& other : fields) {
        if (other.table == subject->table)
            replace_first(message, fmt::format(" {},", other.key),
                          fmt::format(" “{}”,", other.label));
    }
    return message;
}

}  // namespace

// Has one overload for each kind of request.
struct ExperimentController::Handler {
    ExperimentController& self;

    void operator()(const ToggleEvolution&) const {
        if (self.suspended_) return;
        if (self.experiment_.running()) return self.experiment_.send(PauseEvolution{});
        self.view_.newest_champion = true;
        self.experiment_.send(ResumeEvolution{});
    }
    void operator()(const RunOneGeneration&) const {
        if (self.experiment_.running() || self.suspended_) return;
        self.view_.newest_champion = true;
        self.experiment_.send(StepGeneration{});
    }
    void operator()(const EditSettings& request) const {
        const Environment before = self.experiment_.editor().draft().world.environment;
        self.forget_new_run();
        self.experiment_.editor().edit(request.settings, request.field);
        self.follow_world(before);
        self.services_.feedback.log().write("edited", {{"field", request.field}});
    }
    void operator()(const FinishEdit&) const { self.commit(); }
    void operator()(const DrawGround& request) const {
        ExperimentSettings edited = self.experiment_.editor().draft();
        TerrainSettings& terrain = edited.world.environment.terrain;
        auto drawn = with_stroke(terrain, request.stroke);
        if (!drawn)
            return self.services_.feedback.tell(
                NoticeKind::kProblem, "Nothing was drawn: " + drawn.error().message + ".");
        terrain = *std::move(drawn);
        (*this)(EditSettings{std::move(edited), "environment.terrain-points"});
        self.commit();
    }
    void operator()(const UndoEdit&) const {
        if (!self.viewer_.undo_gene_edit()) self.change_draft(&SettingsEditor::undo);
    }
    void operator()(const RedoEdit&) const {
        if (!self.viewer_.redo_gene_edit()) self.change_draft(&SettingsEditor::redo);
    }
    void operator()(const StartNewRun& request) const {
        const EvolutionSnapshot& snapshot = self.experiment_.snapshot();
        std::vector<GenomePtr> founders;
        if (request.keep_population) founders = genomes_of(snapshot.population);
        const RunSeed seed = request.same_seed ? RunSeed::kSame : RunSeed::kNew;
        self.begin_run(std::move(founders), seed);
    }
    void operator()(const StartFromShown&) const {
        const Playback& playback = self.viewer_.playback();
        if (playback.empty()) return;
        self.begin_run({playback.exhibit().genome()}, RunSeed::kNew);
    }
    void operator()(const EvolveShown& request) const {
        if (self.suspended_ || self.viewer_.playback().empty()) return;
        if (request.in_its_world) self.take_over_world(self.viewer_.playback().exhibit());
        self.viewer_.draw_or_play(false);
        (*this)(StartFromShown{});
        self.view_.newest_champion = true;
        self.experiment_.send(ResumeEvolution{});
    }
    void operator()(const DrawNewCreature&) const {
        self.viewer_.show({.creature = unjudged(std::make_shared<const Genome>(first_part()),
                                                std::make_shared<const ExperimentSettings>(
                                                    self.experiment_.editor().draft()),
                                                "drawn"),
                           .source = ExhibitSource::kFounder,
                           .title = "Drawn creature"});
        self.viewer_.draw_or_play(true);
        self.viewer_.carry_out(FitView{});
    }
    void operator()(const DropStructuralEdits&) const {
        SettingsEditor& editor = self.experiment_.editor();
        editor.edit(with_live_fields(*self.experiment_.snapshot().settings, editor.draft(),
                                     self.experiment_.fields()),
                    "run");
        self.commit();
    }
    void operator()(const AddImmigrants& request) const {
        self.experiment_.send(request);
        self.services_.feedback.log().write("newcomers");
    }
    void operator()(const FindSetting&) const {
        self.view_.panels.left = true;
        ++self.find_asked_;
    }
    void operator()(const ShowSetting& request) const {
        self.view_.panels.left = true;
        if (!is_plain(request.path)) self.view_.all_settings = true;
        self.shown_ = request.path;
        ++self.show_asked_;
    }
};

ExperimentController::ExperimentController(const Services& services, ViewState& view,
                                           ViewerController& viewer, ExperimentSettings settings,
                                           std::shared_ptr<EvaluationBackend> backend)
    : services_(services),
      view_(view),
      viewer_(viewer),
      experiment_(std::move(settings), services.kinds, std::move(backend)),
      museum_(services) {}

void ExperimentController::keep_in(const std::filesystem::path& file,
                                   const std::filesystem::path& museum) {
    museum_.keep_in(museum);
    experiment_.take_founders_from(museum);
    experiment_.autosave_in(file);
}

void ExperimentController::carry_out(const ExperimentRequest& request) {
    std::visit(Handler{*this}, request);
}

ExperimentView ExperimentController::facts() const {
    return {.fields = experiment_.fields(),
            .snapshot = experiment_.snapshot(),
            .progress = experiment_.progress(),
            .editor = experiment_.editor(),
            .find_asked = find_asked_,
            .show_asked = show_asked_,
            .shown = shown_,
            .previous_run = !experiment_.files().before().empty(),
            .new_run = new_run_last()};
}

void ExperimentController::poll() {
    experiment_.poll();
    museum_.see(experiment_.snapshot());
    if (experiment_.snapshot().status != EngineStatus::kPaused) resuming_ = false;
}

// One mode may be left and another one entered between two snapshots.
void ExperimentController::suspend() {
    evolved_before_ = experiment_.running() || resuming_;
    resuming_ = false;
    experiment_.send(PauseEvolution{});
    suspended_ = true;
}

void ExperimentController::release(bool resume) {
    suspended_ = false;
    resuming_ = resume && evolved_before_;
    if (resuming_) experiment_.send(ResumeEvolution{});
}

void ExperimentController::show_founder(std::size_t place) {
    const auto settings = std::make_shared<const ExperimentSettings>(experiment_.editor().draft());
    viewer_.show({.creature = {0, make_immigrant(*settings, services_.kinds, 0, place), settings},
                  .source = ExhibitSource::kFounder,
                  .title = fmt::format("Random creature {}", place + 1)});
}

void ExperimentController::take_over_world(const Exhibit& exhibit) {
    const ExperimentSettings& its = exhibit.settings();
    ExperimentSettings settings = experiment_.editor().draft();
    settings.goal = its.goal;
    settings.world = its.world;
    settings.expression = its.expression;
    if (const GoalKind* goal = services_.kinds.goals.find(its.goal)) allow_senses(settings, *goal);
    experiment_.editor().edit(completed(std::move(settings), experiment_.fields()), "goal");
    experiment_.editor().finish();
}

void ExperimentController::begin_run(std::vector<GenomePtr> founders, RunSeed seed) {
    const bool any = !experiment_.snapshot().history.empty();
    if (!founders.empty()) leave_museum();
    const Status status = experiment_.start_new_run(std::move(founders), seed);
    if (!status) return services_.feedback.report(status);
    services_.feedback.log().write("new run");
    new_run_last_ = any;
    if (experiment_.begins_at_random()) {
        view_.newest_champion = false;  // that of the run before is still in the snapshot
        show_founder(0);
    }
    const ExperimentSettings& draft = experiment_.editor().draft();
    const bool nothing_there = draft.population.museum > 0.0 && experiment_.begins_at_random();
    services_.feedback.tell(
        NoticeKind::kDone,
        fmt::format("A new run begins, with seed {}.{}{}", draft.seed,
                    nothing_there ? " The museum has no creature for this world yet." : "",
                    any ? " The one before is kept; Ctrl+Z goes back to it." : ""));
}

// Founders that the user chose take the place of those of the museum.
void ExperimentController::leave_museum() {
    ExperimentSettings settings = experiment_.editor().draft();
    if (settings.population.museum <= 0.0) return;
    settings.population.museum = 0.0;
    experiment_.editor().edit(std::move(settings), "population.museum");
    experiment_.editor().finish();
}

void ExperimentController::commit() {
    const Status status = experiment_.commit();
    if (!status)
        services_.feedback.tell(NoticeKind::kProblem,
                                with_labels(status.error().message, experiment_.fields()));
}

// A change of the environment acts on the displayed creature at once; other edits do not.
void ExperimentController::change_draft(void (SettingsEditor::*change)()) {
    const Environment before = experiment_.editor().draft().world.environment;
    (experiment_.editor().*change)();
    follow_world(before);
    commit();
}

void ExperimentController::follow_world(const Environment& before) {
    const Environment& after = experiment_.editor().draft().world.environment;
    if (!(after == before)) viewer_.use_environment(after);
}

void ExperimentController::follow_status() {
    const EvolutionSnapshot& snapshot = experiment_.snapshot();
    // A short generation begins and ends between two frames.
    const bool ended =
        snapshot.status == EngineStatus::kPaused && snapshot.generation != seen_generation_;
    seen_generation_ = snapshot.generation;
    if (snapshot.status == seen_status_ && !ended) return;
    seen_status_ = snapshot.status;
    switch (seen_status_) {
        case EngineStatus::kRunning:
            services_.feedback.log().write("running");
            break;
        case EngineStatus::kPaused:
            services_.feedback.log().write("paused");
            break;
        case EngineStatus::kFailed:
            services_.feedback.tell(
                NoticeKind::kProblem,
                fmt::format("Evolution stopped: {}. Press Evolve to try again.", snapshot.failure));
            break;
    }
}

}  // namespace cambrian
