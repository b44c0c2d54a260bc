#pragma once

// Experiment files, *.cambrian: a whole experiment in an SQLite database (evolution.md 10.5), one
// transaction a generation, so that whatever happens at most the generation in flight is lost. The
// tables are described in assets/help/experiment_file.md.

#include "core/result.h"
#include "evolution/evolution_kinds.h"
#include "evolution/experiment_log.h"
#include "persist/picking_record.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

namespace cambrian {

struct OpenedExperiment;

class ExperimentFile final : public ExperimentLog {
public:
    // A new file, where there is none yet; an empty path: one without a name that vanishes with
    // this object.
    static Result<std::shared_ptr<ExperimentFile>> create(const std::filesystem::path& path,
                                                          const EvolutionKinds& kinds);
    ~ExperimentFile() override;

    Status begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders) override;
    Status note(const NotedCommand& command) override;
    Status record(const Evolution& evolution) override;
    // Any thread.
    Status keep_picking(const PickingRecord& picking);
    Status keep_stars(const std::vector<ChampionRecord>& stars);

    // The whole experiment as another file, in place of what is there; everything from now on goes
    // there too. Any thread.
    Status move_to(const std::filesystem::path& path);
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

    const EvolutionKinds& kinds_;
    mutable std::mutex mutex_;
    std::unique_ptr<Open> open_;
};

// An experiment file to be gone on with.
struct OpenedExperiment {
    std::shared_ptr<ExperimentFile> file;
    SavedExperiment saved;
    PickingRecord picking;
    std::vector<ChampionRecord> stars;
};

// Fails, leaving the file as it is, if it is damaged, of another kind or version, or in use.
Result<OpenedExperiment> open_experiment(const std::filesystem::path& path,
                                         const EvolutionKinds& kinds);
// To look at only.
Result<SavedExperiment> load_experiment(const std::filesystem::path& path,
                                        const EvolutionKinds& kinds);

}  // namespace cambrian
