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
    // A new experiment, generation 0 of these founders and settings, without a name: it vanishes
    // with this object unless it is moved.
    static Result<std::shared_ptr<ExperimentFile>> create(const EvolutionKinds& kinds,
                                                          const SettingsPtr& settings,
                                                          const std::vector<GenomePtr>& founders);
    ~ExperimentFile();

    // As ExperimentLog has them.
    Status note(const NotedCommand& command);
    Status record(const Evolution& evolution);
    // Any thread.
    Status keep_picking(const PickingRecord& picking);
    Status keep_stars(const std::vector<JudgedIndividual>& stars);

    using Existing = PendingFile::Existing;
    // Copies the experiment to another file, which appears atomically; later generations are
    // written there. Any thread.
    Status move_to(const std::filesystem::path& path, Existing existing = Existing::kReplace);
    // Any thread; empty for one without a name.
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

// An experiment file to be gone on with.
struct OpenedExperiment {
    std::shared_ptr<ExperimentFile> file;
    SavedExperiment saved;
    PickingRecord picking;
    std::vector<JudgedIndividual> stars;
};

// One of an older version is brought up to this program's. Fails, leaving the file as it is, if it
// is damaged, of another kind or newer, or in use.
Result<OpenedExperiment> open_experiment(const std::filesystem::path& path,
                                         const EvolutionKinds& kinds);
// To look at only; the file is not changed.
Result<SavedExperiment> load_experiment(const std::filesystem::path& path,
                                        const EvolutionKinds& kinds);

}  // namespace cambrian
