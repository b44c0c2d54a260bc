#pragma once

// The experiment being worked on: the engine and the settings as edited.

#include "core/stopwatch.h"
#include "evolution/engine/engine.h"
#include "persist/experiment/kept_experiment.h"
#include "studio/experiment/progress_view.h"
#include "studio/experiment/settings_editor.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace cambrian {

class OpenExperiment {
public:
    // Settings must pass check_settings.
    OpenExperiment(ExperimentSettings settings, const EvolutionKinds& kinds,
                   std::shared_ptr<EvaluationBackend> backend);

    // From now on new runs are kept in this file (KeptExperiment); before, nowhere for long.
    void autosave_in(const std::filesystem::path& file);
    // Goes on with an experiment that was kept, paused.
    void go_on(SavedExperiment saved, std::shared_ptr<ExperimentFile> file,
               const std::filesystem::path& path);
    // It is kept there from now on.
    void moved_to(const std::filesystem::path& path) { file_ = path; }
    // The file a person gave it; empty if none.
    const std::filesystem::path& file() const { return file_; }
    // Where the present one is kept; any thread.
    const std::shared_ptr<KeptExperiment>& kept() const { return kept_; }

    // Once a frame: sends what waited for room and measures progress.
    void poll();
    const EvolutionSnapshot& snapshot() const { return *snapshot_; }
    const ProgressView& progress() const { return progress_; }
    const std::vector<SettingField>& fields() const { return fields_; }
    const SettingsEditor& editor() const { return editor_; }
    SettingsEditor& editor() { return editor_; }
    bool running() const { return snapshot_->status == EngineStatus::kRunning; }
    // Nothing was evaluated yet, so that everything may still be edited.
    bool fresh() const;

    // The engine carries out a command as soon as its inbox has room.
    void send(EngineCommand command);
    // The engine gets what was edited: all of it while fresh, live fields otherwise.
    Status commit();
    // A new generation 0 with the draft, from these creatures or random ones.
    Status start_new_run(std::vector<GenomePtr> founders);
    // A new generation 0 with other settings.
    Status replace(const ExperimentSettings& settings);

private:
    void start(std::vector<GenomePtr> founders);
    void measure();

    const EvolutionKinds& kinds_;
    std::vector<SettingField> fields_;
    SettingsEditor editor_;
    std::filesystem::path autosave_;
    std::filesystem::path file_;
    std::shared_ptr<KeptExperiment> kept_;
    EvolutionEngine engine_;
    std::deque<EngineCommand> unsent_;  // the engine's inbox was full
    std::shared_ptr<const EvolutionSnapshot> snapshot_;
    ProgressView progress_;
    // For the rate: what was done when, within the present generation.
    Stopwatch since_mark_;
    std::uint32_t marked_done_ = 0;
    std::uint32_t marked_generation_ = 0;
};

// All fields written out, so that maps name every kind and equal settings compare equal.
ExperimentSettings completed(ExperimentSettings settings, const std::vector<SettingField>& fields);

}  // namespace cambrian
