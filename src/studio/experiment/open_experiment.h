#pragma once

// The open experiment: the evolution engine and the settings as edited.

#include "core/stopwatch.h"
#include "evolution/engine/engine.h"
#include "persist/experiment/run_files.h"
#include "studio/experiment/progress_view.h"
#include "studio/experiment/settings_editor.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cambrian {

// The seed of a new run: another one than that of the present run, unless the user chose one in the
// draft, or the same.
enum class RunSeed : std::uint8_t { kNew, kSame };

class OpenExperiment {
public:
    // The settings must pass check_settings().
    OpenExperiment(ExperimentSettings settings, const EvolutionKinds& kinds,
                   std::shared_ptr<EvaluationBackend> backend);

    // Saves new runs in this file from now on (see RunFiles). Before this call, runs are saved in a
    // temporary file.
    void autosave_in(const std::filesystem::path& file);
    // Runs whose settings say so take founders from this museum from now on.
    void take_founders_from(const std::filesystem::path& museum) { museum_ = museum; }
    // Continues a saved experiment; evolution is paused at first.
    void go_on(SavedExperiment saved, std::shared_ptr<ExperimentFile> file,
               const std::filesystem::path& path);
    // The present run and the one before are kept there.
    const RunFiles& files() const { return files_; }
    RunFiles& files() { return files_; }
    // The number of runs that the user began so far.
    unsigned runs_begun() const { return runs_begun_; }

    // Must be called once a frame: takes the newest snapshot and measures progress.
    void poll();
    const EvolutionSnapshot& snapshot() const { return *snapshot_; }
    const ProgressView& progress() const { return progress_; }
    const std::vector<SettingField>& fields() const { return fields_; }
    const SettingsEditor& editor() const { return editor_; }
    SettingsEditor& editor() { return editor_; }
    bool running() const { return snapshot_->status == EngineStatus::kRunning; }
    // Whether nothing has been evaluated yet, so that every setting may still be edited.
    bool fresh() const;
    // Whether the run began with random creatures that its seed gives.
    bool begins_at_random() const { return begins_at_random_; }

    // Sends a command to the engine, as soon as its inbox has room.
    void send(EngineCommand command) { engine_.send(std::move(command)); }
    // Sends the draft to the engine: all settings while fresh(), otherwise the live ones only.
    // Edits that make it contradict itself are taken back, and the error says why.
    Status commit();
    // Starts a new run with the draft settings from these founders or, if there are none, those
    // of the museum or random ones. A new seed is drawn into the draft.
    Status start_new_run(std::vector<GenomePtr> founders, RunSeed seed = RunSeed::kNew);
    // Starts a new run with other settings.
    Status replace(const ExperimentSettings& settings);

private:
    void start(std::vector<GenomePtr> founders);
    void draw_seed();
    void measure();

    const EvolutionKinds& kinds_;
    std::vector<SettingField> fields_;
    SettingsEditor editor_;
    RunFiles files_;
    std::filesystem::path museum_;
    unsigned runs_begun_ = 0;
    std::uint64_t run_seed_;  // of the present run
    bool begins_at_random_ = true;
    EvolutionEngine engine_;
    std::shared_ptr<const EvolutionSnapshot> snapshot_;
    ProgressView progress_;
    // The creatures evaluated at the last reading of the rate, and the generation it was in.
    Stopwatch since_mark_;
    std::uint32_t marked_done_ = 0;
    std::uint32_t marked_generation_ = 0;
};

// Returns the settings with an entry for every field, so that equal settings compare equal.
ExperimentSettings completed(ExperimentSettings settings, const std::vector<SettingField>& fields);

}  // namespace cambrian
