#pragma once

// The files of the runs in one window: of the present run, and of the one before it.

#include "evolution/engine/snapshot.h"
#include "persist/experiment/kept_experiment.h"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cambrian {

class RunFiles {
public:
    explicit RunFiles(const EvolutionKinds& kinds)
        : kinds_(kinds), kept_(std::make_shared<KeptExperiment>(std::filesystem::path(), kinds)) {}

    // Saves runs that begin from now on in this file (see KeptExperiment). The run found there, or
    // beside it, counts as the run before.
    void autosave_in(const std::filesystem::path& file);
    // Must be called when a run begins or an experiment is opened; `ended` is the last snapshot of
    // the present run.
    void begin(const EvolutionSnapshot& ended);
    void open(const EvolutionSnapshot& ended, std::shared_ptr<ExperimentFile> file,
              const std::filesystem::path& path);
    // Must be called when the user saved the run under another path; it is kept there from now on.
    void moved_to(const std::filesystem::path& path) { chosen_ = path; }

    // The file that the user chose; empty if none.
    const std::filesystem::path& chosen() const { return chosen_; }
    // The file of the run before; empty if none is known.
    std::filesystem::path before() const;
    // The place where the present run is saved; may be used on any thread.
    const std::shared_ptr<KeptExperiment>& kept() const { return kept_; }

private:
    void remember(const EvolutionSnapshot& ended);

    const EvolutionKinds& kinds_;
    std::filesystem::path autosave_;
    std::filesystem::path chosen_;
    std::shared_ptr<KeptExperiment> kept_;
    std::filesystem::path before_;  // the file of the run before when that run ended
    std::uint64_t ended_ = 0;       // the number of the run that ended last, in snapshots
};

}  // namespace cambrian
