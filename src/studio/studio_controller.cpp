#include "studio/studio_controller.h"

#include "core/stopwatch.h"
#include "evolution/fields/setting_words.h"
#include "studio/actions/action.h"

#include <utility>
#include <variant>

namespace cambrian {

// Forwards the requests of each subject to its controller.
struct StudioController::Router {
    StudioController& self;

    void operator()(const ViewerRequest& request) const {
        if (std::holds_alternative<EditGenes>(request)) self.experiment_.forget_new_run();
        if (!self.picking_.take_over(request)) self.viewer_.carry_out(request);
    }
    void operator()(const ExperimentRequest& request) const {
        if (!std::holds_alternative<UndoEdit>(request) || !self.experiment_.new_run_last())
            return self.experiment_.carry_out(request);
        self.experiment_.forget_new_run();
        self.files_.carry_out(OpenPreviousRun{});
    }
    void operator()(const GenerationsRequest& request) const {
        self.generations_.carry_out(request);
    }
    void operator()(const PickingRequest& request) const {
        if (std::holds_alternative<ToggleHandPicking>(request))
            self.preserve_.carry_out(ClosePreserve{});
        self.picking_.carry_out(request);
    }
    void operator()(const PreserveRequest& request) const { self.preserve_.carry_out(request); }
    void operator()(const FilesRequest& request) const { self.files_.carry_out(request); }
    void operator()(const GuideRequest& request) const { self.guide_.carry_out(request); }
    void operator()(const MachinesRequest& request) const { self.machines_.carry_out(request); }
    void operator()(const ComparisonRequest& request) const { self.comparison_.carry_out(request); }
    void operator()(const CoachRequest& request) const { self.coach_.carry_out(request); }
    void operator()(const WindowRequest& request) const {
        if (std::holds_alternative<TogglePresentation>(request)) self.switch_presentation();
        self.window_.carry_out(request);
    }
};

StudioController::StudioController(const Preferences& remembered, const EvolutionKinds& kinds,
                                   const MachineOptions& machines,
                                   const std::filesystem::path& status_log,
                                   const EvolutionKinds* elsewhere)
    : view_(remembered.view),
      services_(kinds, elsewhere, status_log),
      window_(services_.feedback, view_),
      guide_(services_.shared, view_),
      viewer_(services_.shared, view_),
      machines_(services_.shared, experiment_, machines),
      experiment_(services_.shared, view_, viewer_, remembered.settings, machines_.own_cores()),
      generations_(services_.shared, view_, viewer_, experiment_),
      picking_(services_.shared, view_, viewer_, experiment_, machines.threads),
      preserve_(services_.shared, {viewer_, experiment_, generations_, picking_}, machines.threads),
      comparison_(services_.shared, experiment_, machines.threads),
      coach_(services_.shared, view_, viewer_, experiment_),
      files_(services_.shared, view_, {viewer_, experiment_, generations_, picking_, preserve_}),
      memory_({view_,
               experiment_.open().editor().draft(),
               remembered.experiment,
               remembered.cluster,
               {},
               remembered.recent}) {
    machines_.begin(remembered.cluster);
    files_.use_recent(remembered.recent);
    if (!remembered.fault.empty()) services_.feedback.tell(NoticeKind::kProblem, remembered.fault);
}

void StudioController::remember_in(const std::filesystem::path& folder) {
    memory_.use(folder);
    const std::filesystem::path museum = own_museum(folder);
    if (!folder.empty()) experiment_.keep_in(own_experiment(folder), museum);
    files_.use_museum(museum);
    preserve_.keep_in(folder);
    comparison_.keep_in(folder);
    comparison_.take_founders_from(museum);
}

void StudioController::reopen_last() {
    const std::filesystem::path last = memory_.last_experiment();
    if (!last.empty()) files_.reopen(last);
}

Preferences StudioController::remembered() const {
    const OpenExperiment& experiment = experiment_.open();
    return {view_,
            experiment.editor().settled(),
            files_.reopening() ? memory_.experiment() : experiment.files().chosen().string(),
            machines_.memory(),
            {},
            files_.recent()};
}

void StudioController::keep_memory() {
    memory_.keep(remembered(), services_.shared);
}

void StudioController::close() {
    experiment_.close();
    keep_memory();
}

void StudioController::use_assets(const std::filesystem::path& folder) {
    guide_.read(folder / "help", keys_text(),
                words_text(std::as_const(experiment_).open().fields()));
    files_.use_samples({folder / "creatures", folder / "creatures-3d"});
    files_.use_challenges(folder / "challenges");
    coach_.use_samples(folder / "creatures");
    preserve_.use_assets(folder);
}

void StudioController::update(double now, double elapsed) {
    services_.feedback.set_time(now);
    services_.worker.deliver();
    files_.update(elapsed);
    experiment_.poll();
    generations_.log_finished();
    experiment_.follow_status();
    machines_.update(now);
    comparison_.update();
    if (!picking_.on() && !preserve_.on()) generations_.follow_newest();
    generations_.follow_audit();
    coach_.update(elapsed);
    const OpenExperiment& open = std::as_const(experiment_).open();
    guide_.follow({open.running(), open.snapshot().champions.size(),
                   open.editor().draft().world.environment, view_.look, files_.saves()});
    present(now);
    const Stopwatch spent;
    picking_.update(elapsed);
    preserve_.update();
    if (!picking_.grid_shown() && !preserve_.world_shown())
        viewer_.update(elapsed, std::as_const(experiment_).open().snapshot());
    playback_seconds_ = spent.seconds();
    generations_.keep_stars();
    services_.feedback.choose_notice();
    if (memory_.due(now)) keep_memory();
}

std::vector<Exhibit> StudioController::sample_exhibits() const {
    std::vector<Exhibit> exhibits;
    for (const Sample& sample : files_.samples().samples) {
        if (sample.phenotype == nullptr) continue;
        Exhibit exhibit = exhibit_of(sample.creature, ExhibitSource::kSample);
        exhibit.title = sample.title;
        exhibits.push_back(std::move(exhibit));
    }
    return exhibits;
}

void StudioController::switch_presentation() {
    if (presentation_.on()) {
        if (std::optional<Exhibit> before = presentation_.end()) viewer_.show(*std::move(before));
        view_.newest_champion = newest_before_;
        return;
    }
    newest_before_ = std::exchange(view_.newest_champion, false);
    std::optional<Exhibit> before;
    if (!viewer_.playback().empty()) before = viewer_.playback().exhibit();
    presentation_.begin(best_exhibits(generations_.facts().stars.all(),
                                      std::as_const(experiment_).open().snapshot().champions),
                        std::move(before));
    files_.want_samples();
}

// While a run has no champions yet, the samples are shown as soon as they are read.
void StudioController::present(double now) {
    if (!presentation_.on()) return;
    if (presentation_.empty()) presentation_.show(sample_exhibits());
    const Playback& playback = viewer_.playback();
    const bool over = playback.empty() || playback.trial().finished();
    if (const Exhibit* next = presentation_.update(now, over)) {
        viewer_.show(*next);
        viewer_.carry_out(FitView{});
    }
}

void StudioController::carry_out(Requests& requests) {
    viewer_.clear_highlight();
    window_.clear_focus();
    for (const StudioRequest& request : requests.take())
        std::visit(Router{*this}, request);
}

FrameContext StudioController::frame_context() const {
    return {.kinds = services_.shared.kinds,
            .view = view_,
            .experiment = experiment_.facts(),
            .generations = generations_.facts(),
            .viewer = viewer_.facts(),
            .files = files_.facts(),
            .guide = guide_.facts(),
            .window = window_.facts(),
            .picking = picking_.facts(),
            .machines = &machines_.facts(),
            .comparison = &comparison_.facts(),
            .coach = coach_.facts(),
            .preserve = preserve_.facts(),
            .preserve_card = preserve_.card()};
}

bool StudioController::animating() const {
    const Notice* notice = services_.feedback.notice();
    const bool fading = notice != nullptr && notice->fades();
    const bool moving = preserve_.world_shown() ? preserve_.animating() : viewer_.animating();
    return moving || files_.animating() || picking_.on() || experiment_.open().running() ||
           comparison_.facts().running || !services_.worker.idle() || fading;
}

}  // namespace cambrian
