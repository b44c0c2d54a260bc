#pragma once

// Experiment files, *.cambrian: an experiment in an SQLite database (persist/README.md 3). Each
// generation is one transaction, so a crash loses at most the generation that is being evaluated.
// assets/help/experiment_file.md describes the tables.

#include "core/files/pending_file.h"
#include "core/result.h"
#include "evolution/engine/experiment_log.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/records/picking_record.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

namespace cambrian {

struct OpenedExperiment;

class ExperimentFile {
public:
    // Creates an experiment with generation 0 of these founders and settings. Its file has no name
    // and is deleted with this object unless move_to() is called.
    static Result<std::shared_ptr<ExperimentFile>> create(const EvolutionKinds& kinds,
                                                          const SettingsPtr& settings,
                                                          const std::vector<GenomePtr>& founders);
    ~ExperimentFile();

    // These functions implement ExperimentLog.
    Status note(const NotedCommand& command);
    Status record(const Evolution& evolution);
    Status crown(const JudgedIndividual& champion);
    // May be called on any thread.
    Status keep_picking(const PickingRecord& picking);
    Status keep_stars(const std::vector<JudgedIndividual>& stars);

    using Existing = PendingFile::Existing;
    // Copies the experiment to another file, which appears atomically, and writes later generations
    // there. May be called on any thread.
    Status move_to(const std::filesystem::path& path, Existing existing = Existing::kReplace);
    // May be called on any thread. Empty for a file without a name.
    std::filesystem::path path() const;

private:
    friend Result<OpenedExperiment> open_experiment(const std::filesystem::path& path,
                                                    const EvolutionKinds& kinds);
    struct Open;
    ExperimentFile(std::unique_ptr<Open> open, const EvolutionKinds& kinds);

    template <class Write>
    Status write(Write write);
    Status copy_into(const std::filesystem::path& temporary) const;
    Status go_on_in(const std::filesystem::path& path);

    const EvolutionKinds& kinds_;
    mutable std::mutex mutex_;
    std::unique_ptr<Open> open_;
};

// An experiment file that was opened to continue it.
struct OpenedExperiment {
    std::shared_ptr<ExperimentFile> file;
    SavedExperiment saved;
    PickingRecord picking;
    std::vector<JudgedIndividual> stars;
};

// Opens an experiment and upgrades older versions. Fails without a change of the file if it is
// damaged, of another kind, newer or in use.
Result<OpenedExperiment> open_experiment(const std::filesystem::path& path,
                                         const EvolutionKinds& kinds);
// Loads an experiment without changing its file.
Result<SavedExperiment> load_experiment(const std::filesystem::path& path,
                                        const EvolutionKinds& kinds);

}  // namespace cambrian
