#pragma once

// Writes an experiment into its tables, a transaction a call. Throws DatabaseError; what failed has
// changed nothing and may be tried again.

#include "evolution/experiment_log.h"
#include "persist/database.h"
#include "persist/deflated_text.h"
#include "persist/kept_individuals.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

class ExperimentWriter {
public:
    // Of a database that has the tables.
    ExperimentWriter(Database database, const EvolutionKinds& kinds);
    ExperimentWriter(const ExperimentWriter&) = delete;
    ExperimentWriter& operator=(const ExperimentWriter&) = delete;

    // What a database opened to be gone on with holds; population: rows of the latest one.
    void remember(const SavedExperiment& saved, const std::vector<RowRef>& population);
    // The database is a copy of the other's.
    void remember(const ExperimentWriter& other) { known_ = other.known_; }

    void begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders);
    void note(const NotedCommand& noted);
    void record(const Evolution& evolution);
    void copy_to(const std::filesystem::path& path) const;

private:
    // What is in the tables already.
    struct Known {
        KeptIndividuals::Knowledge individuals;
        SettingsPtr settings;  // written last
        std::int64_t settings_row = 0;
        std::vector<IndividualPtr> novel;
    };

    template <class Work>
    void transact(Work work);
    std::int64_t row_of(const SettingsPtr& settings);
    void insert_command(const char* command, std::uint32_t generation,
                        std::optional<std::int64_t> settings, std::optional<double> share);
    void insert_genotype(const char* command, std::uint32_t generation, const Genome& genome);
    void insert(std::uint32_t generation, const ChangeSettings& command);
    void insert(std::uint32_t generation, const InjectGenome& command);
    void insert(std::uint32_t generation, const AddNewcomers& command);
    void insert_population(const Evolution& evolution);
    void insert_novel(const SelectionMemory& memory);
    void insert_generation(const Evolution& evolution);

    Database database_;  // outlives its statements
    const EvolutionKinds& kinds_;
    Known known_;
    KeptIndividuals kept_;
    Deflater deflater_;
    Statement insert_settings_;
    Statement insert_command_;
    Statement clear_population_;
    Statement insert_place_;
    Statement clear_novel_;
    Statement insert_novel_;
    Statement insert_generation_;
};

}  // namespace cambrian
