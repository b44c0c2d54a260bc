#pragma once

// The file of the experiment in a window. It is the autosave file until the user saves the
// experiment under a name. An experiment that has not evolved leaves no file.

#include "persist/experiment/experiment_file.h"

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace cambrian {

class KeptExperiment final : public ExperimentLog {
public:
    // Starts a new experiment. `autosave` is its file, which is written from the first generation
    // on. An older file of that name is kept as the previous run (previous_run()). If `autosave` is
    // empty, the experiment gets a temporary file.
    KeptExperiment(std::filesystem::path autosave, const EvolutionKinds& kinds)
        : autosave_(std::move(autosave)), kinds_(kinds) {}
    // Continues an experiment that was opened.
    KeptExperiment(std::shared_ptr<ExperimentFile> file, const EvolutionKinds& kinds)
        : kinds_(kinds), file_(std::move(file)) {}

    Status begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders) override;
    Status note(const NotedCommand& command) override;
    Status record(const Evolution& evolution) override;
    Status crown(const JudgedIndividual& champion) override;
    // Whether the run got the autosave file, so that the run before is now in previous_run(). May
    // be called on any thread; never waits.
    bool took_autosave() const { return took_autosave_; }
    // The following may be called on any thread.
    Status move_to(const std::filesystem::path& path);
    // The file that has the run now; empty if it has no name.
    std::filesystem::path path() const;
    Status keep_picking(const PickingRecord& picking);
    Status keep_stars(const std::vector<JudgedIndividual>& stars);

private:
    struct Beginning {
        SettingsPtr settings;
        std::vector<GenomePtr> founders;
    };

    Result<std::shared_ptr<ExperimentFile>> nameless_file() const;
    Status name_autosave(ExperimentFile& file) const;
    Status use_autosave();
    void take(std::shared_ptr<ExperimentFile> file);

    std::filesystem::path autosave_;
    const EvolutionKinds& kinds_;
    mutable std::mutex mutex_;
    std::atomic<bool> took_autosave_ = false;
    std::shared_ptr<ExperimentFile> file_;
    std::optional<Beginning> beginning_;
    std::vector<NotedCommand> notes_;      // commands recorded before there was a file
    std::vector<JudgedIndividual> stars_;  // given before there was a file
};

// Returns the path of the previous run, beside the autosave file.
std::filesystem::path previous_run(const std::filesystem::path& autosave);

}  // namespace cambrian
