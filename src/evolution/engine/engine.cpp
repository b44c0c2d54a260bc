#include "evolution/engine/engine.h"

#include "evolution/evaluation/terrain_ladder.h"

#include <exception>
#include <utility>

namespace cambrian {
namespace {

constexpr int kUntilPaused = -1;

}  // namespace

EvolutionEngine::EvolutionEngine(SettingsPtr settings, const EvolutionKinds& kinds,
                                 std::shared_ptr<EvaluationBackend> backend,
                                 std::shared_ptr<ExperimentLog> log)
    : kinds_(kinds), backend_(std::move(backend)) {
    apply(StartExperiment{std::move(settings), {}, std::move(log)});
    publish();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

EvolutionEngine::~EvolutionEngine() {
    thread_.request_stop();
    thread_.join();
}

void EvolutionEngine::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const bool commanded = inbox_.drain([this](EngineCommand command) {
            std::visit([this](auto& each) { apply(std::move(each)); }, command);
        });
        if (commanded) publish();
        const bool paused = generations_to_run_ == 0;
        if (paused && !unaudited_) {
            inbox_.wait(stop);
            continue;
        }
        try {
            inbox_.work_until_command(stop, [this, paused](const std::stop_token& interrupted) {
                paused ? audit_champion(interrupted) : run_generation(interrupted);
            });
        } catch (const std::exception& failure) {
            stop_with(failure.what());
            publish();
        }
    }
}

void EvolutionEngine::run_generation(const std::stop_token& interrupted) {
    const Stopwatch watch;
    const SettingsPtr before = evolution_->shared_settings();
    const bool evaluated = evolution_->evaluate(*backend_, progress_, interrupted);
    evaluating_ += watch.seconds();
    if (changed_by_run(*before, evolution_->settings()))
        shown_.journal.push_back({evolution_->generation(), evolution_->shared_settings()});
    if (!evaluated && !interrupted.stop_requested()) {
        stop_with(backend_->status().failure);
        publish();
    }
    if (!evaluated) return;
    if (const Status kept = keep_generation(); !kept) {
        stop_with(kept.error().message);
        publish();
        return;
    }
    show_generation();
    unaudited_.emplace();
    unaudited_->settings = evolution_->shared_settings();
    unaudited_->generation = evolution_->generation();
    unaudited_->population = evolution_->population();
    unaudited_->memory = evolution_->selection_memory();
    evolution_->breed();
    for (SteeringCommand& command : std::exchange(deferred_, {}))
        std::visit([this](auto& each) { apply(std::move(each)); }, command);
    if (generations_to_run_ > 0) --generations_to_run_;
    if (generations_to_run_ == 0) shown_.status = EngineStatus::kPaused;
    publish();
}

// While evolution is paused, the newest champion becomes the audited one, as at the end of a run
// without a window.
void EvolutionEngine::audit_champion(const std::stop_token& interrupted) {
    EvaluationProgress progress;  // not that of the generation being evaluated
    const auto champion =
        Evolution(*unaudited_, kinds_).confirmed_champion(*backend_, progress, interrupted);
    if (!champion && interrupted.stop_requested()) return;
    unaudited_.reset();
    JudgedIndividual& shown = shown_.champions.back();
    if (!champion || *champion == shown.individual) return;
    const JudgedIndividual audited{shown.generation, *champion, shown.settings};
    const Status kept = log_ ? log_->crown(audited) : Status();
    if (kept) shown = audited;
    if (!kept) stop_with(kept.error().message);
    publish();
}

void EvolutionEngine::show_generation() {
    shown_.population = evolution_->population();
    shown_.history = evolution_->history();
    shown_.wall_times.resize(shown_.history.size(), 0.0);
    shown_.wall_times.back() = std::exchange(evaluating_, 0.0);
    shown_.champions.push_back({evolution_->generation(), evolution_->population().front(),
                                evolution_->shared_settings()});
}

void EvolutionEngine::stop_with(std::string failure) {
    unaudited_.reset();
    generations_to_run_ = 0;
    shown_.status = EngineStatus::kFailed;
    shown_.failure = std::move(failure);
}

Status EvolutionEngine::keep_notes() {
    if (!log_) unkept_notes_.clear();
    if (log_ && unkept_start_) {
        if (Status begun = log_->begin(unkept_start_->settings, unkept_start_->founders); !begun)
            return begun;
        unkept_start_.reset();
    }
    while (!unkept_notes_.empty()) {
        if (Status noted = log_->note(unkept_notes_.front()); !noted) return noted;
        unkept_notes_.pop_front();
    }
    return {};
}

Status EvolutionEngine::keep_generation() {
    if (Status kept = keep_notes(); !kept) return kept;
    return log_ ? log_->record(*evolution_) : Status();
}

// Returns whether the command may act now; records it then, and defers it otherwise.
bool EvolutionEngine::steer(const SteeringCommand& command) {
    if (evolution_->evaluated()) {
        deferred_.push_back(command);
        return false;
    }
    unkept_notes_.push_back({evolution_->generation(), command});
    if (const Status kept = keep_notes(); !kept) stop_with(kept.error().message);
    return true;
}

void EvolutionEngine::apply(PauseEvolution) {
    generations_to_run_ = 0;
    shown_.status = EngineStatus::kPaused;
}

void EvolutionEngine::apply(ResumeEvolution) {
    generations_to_run_ = kUntilPaused;
    shown_.status = EngineStatus::kRunning;
    shown_.failure.clear();
}

void EvolutionEngine::apply(StepGeneration) {
    generations_to_run_ = 1;
    shown_.status = EngineStatus::kRunning;
}

void EvolutionEngine::apply(ChangeSettings command) {
    if (*command.settings == evolution_->settings() || !steer(command)) return;
    evolution_->replace_settings(command.settings);
    shown_.journal.push_back({evolution_->generation(), evolution_->shared_settings()});
}

void EvolutionEngine::apply(InjectGenome command) {
    if (steer(command)) evolution_->inject(std::move(command.genome));
}

void EvolutionEngine::apply(AddImmigrants command) {
    if (steer(command)) evolution_->add_immigrants(command.share);
}

void EvolutionEngine::apply(RescorePopulation command) {
    if (steer(command)) evolution_->rescore();
}

void EvolutionEngine::apply(StartExperiment command) {
    evolution_.emplace(command.settings, kinds_, command.founders);
    start_showing(command.log);
    shown_.journal.push_back({0, command.settings});
    unkept_start_ = std::move(command);
    if (const Status kept = keep_notes(); !kept) stop_with(kept.error().message);
}

void EvolutionEngine::apply(ContinueExperiment command) {
    const SavedExperiment& saved = *command.saved;
    evolution_.emplace(resumed(saved, kinds_));
    start_showing(std::move(command.log));
    unkept_start_.reset();
    shown_.journal = setting_changes(saved);
    shown_.champions = saved.champions;
    if (!saved.latest) return;
    shown_.population = saved.latest->population;
    shown_.history = saved.latest->history;
    shown_.wall_times.resize(shown_.history.size(), 0.0);
}

void EvolutionEngine::apply(UseBackend command) {
    backend_ = std::move(command.backend);
}

// Replaces the experiment by another one.
void EvolutionEngine::start_showing(std::shared_ptr<ExperimentLog> log) {
    log_ = std::move(log);
    unaudited_.reset();
    unkept_notes_.clear();
    deferred_.clear();
    const std::uint64_t experiment = shown_.experiment + 1;
    shown_ = {};
    shown_.experiment = experiment;
    generations_to_run_ = 0;
    evaluating_ = 0.0;
    progress_.done = 0;
    progress_.total = 0;
}

void EvolutionEngine::publish() {
    shown_.generation = evolution_->generation();
    shown_.settings = evolution_->shared_settings();
    snapshots_.publish(std::make_shared<const EvolutionSnapshot>(shown_));
}

}  // namespace cambrian
