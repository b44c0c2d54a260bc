#include "evolution/engine.h"

#include <exception>
#include <utility>

namespace cambrian {
namespace {

constexpr int kUntilPaused = -1;

}  // namespace

EvolutionEngine::EvolutionEngine(SettingsPtr settings, const EvolutionKinds& kinds,
                                 std::unique_ptr<EvaluationBackend> backend)
    : kinds_(kinds), backend_(std::move(backend)) {
    apply(StartExperiment{std::move(settings), {}});
    publish();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

EvolutionEngine::~EvolutionEngine() {
    thread_.request_stop();
    thread_.join();
}

bool EvolutionEngine::send(Command command) {
    // Commands act between trials: whatever is running is interrupted, and goes on afterwards.
    return inbox_.send(std::move(command));
}

const std::shared_ptr<const EvolutionSnapshot>& EvolutionEngine::latest() {
    return snapshots_.latest();
}

void EvolutionEngine::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const bool commanded = inbox_.drain([this](Command command) {
            std::visit([this](auto& each) { apply(std::move(each)); }, command);
        });
        if (commanded) publish();
        if (generations_to_run_ == 0) {
            inbox_.wait(stop);
            continue;
        }
        try {
            inbox_.work_until_command(
                stop, [this](const std::stop_token& interrupted) { run_generation(interrupted); });
        } catch (const std::exception& failure) {
            generations_to_run_ = 0;
            shown_.status = EngineStatus::kFailed;
            shown_.failure = failure.what();
            publish();
        }
    }
}

void EvolutionEngine::run_generation(const std::stop_token& interrupted) {
    if (!evolution_->evaluate(*backend_, progress_, interrupted)) return;
    record_generation();
    evolution_->breed();
    if (generations_to_run_ > 0) --generations_to_run_;
    if (generations_to_run_ == 0) shown_.status = EngineStatus::kPaused;
    publish();
}

void EvolutionEngine::record_generation() {
    shown_.population = evolution_->population();
    shown_.history = evolution_->history();
    shown_.champions.push_back({evolution_->generation(), evolution_->population().front(),
                                evolution_->shared_settings()});
}

void EvolutionEngine::apply(PauseEvolution) {
    generations_to_run_ = 0;
    shown_.status = EngineStatus::kPaused;
}

void EvolutionEngine::apply(ResumeEvolution) {
    generations_to_run_ = kUntilPaused;
    shown_.status = EngineStatus::kRunning;
}

void EvolutionEngine::apply(StepGeneration) {
    generations_to_run_ = 1;
    shown_.status = EngineStatus::kRunning;
}

void EvolutionEngine::apply(ChangeSettings command) {
    if (*command.settings == evolution_->settings()) return;
    evolution_->replace_settings(command.settings);
    shown_.journal.push_back({evolution_->generation(), std::move(command.settings)});
}

void EvolutionEngine::apply(InjectGenome command) {
    evolution_->inject(std::move(command.genome));
}

void EvolutionEngine::apply(AddNewcomers command) {
    evolution_->add_newcomers(command.share);
}

void EvolutionEngine::apply(StartExperiment command) {
    evolution_.emplace(command.settings, kinds_, std::move(command.founders));
    const std::uint64_t experiment = shown_.experiment + 1;
    shown_ = {};
    shown_.experiment = experiment;
    shown_.journal.push_back({0, std::move(command.settings)});
    generations_to_run_ = 0;
    progress_.done = 0;
    progress_.total = 0;
}

void EvolutionEngine::publish() {
    shown_.generation = evolution_->generation();
    shown_.settings = evolution_->shared_settings();
    snapshots_.publish(std::make_shared<const EvolutionSnapshot>(shown_));
}

}  // namespace cambrian
