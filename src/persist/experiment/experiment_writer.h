#pragma once

// Writes an experiment into its tables, one transaction for each call. Throws DatabaseError; a
// failed call changes nothing and may be repeated.

#include "core/deflated_text.h"
#include "evolution/engine/experiment_log.h"
#include "persist/experiment/experiment_reader.h"
#include "persist/records/kept_individuals.h"
#include "persist/records/picking_record.h"
#include "persist/sqlite/database.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

class ExperimentWriter {
public:
    // The database must have the tables.
    ExperimentWriter(Database database, const EvolutionKinds& kinds);
    ExperimentWriter(const ExperimentWriter&) = delete;
    ExperimentWriter& operator=(const ExperimentWriter&) = delete;

    // Records what a database that was opened to continue an experiment contains.
    void remember(const ReadExperiment& read);
    // Records that this database is a copy of the other's.
    void remember(const ExperimentWriter& other) { known_ = other.known_; }

    void begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders);
    void note(const NotedCommand& noted);
    void record(const Evolution& evolution);
    void crown(const JudgedIndividual& champion);
    // Writes new grids and the number of the present one.
    void keep_picking(const PickingRecord& picking);
    void keep_stars(const std::vector<JudgedIndividual>& stars);
    void copy_to(const std::filesystem::path& path) const;

private:
    // The contents of the tables.
    struct Known {
        KeptIndividuals::Knowledge individuals;
        SettingsPtr settings;  // the settings written last
        std::int64_t settings_row = 0;
        std::vector<IndividualPtr> novel;
        // Creatures that the user chose (in grids, on the shelf, with a star) and audited
        // champions.
        KeptIndividuals::Knowledge chosen;
        std::size_t grids = 0;
        // Generation numbers below 0, for scores from picking grids and audits, count down from 0.
        std::int64_t outside_scores = 0;
        std::string simulator;  // version that computed the newest generation
    };

    template <class Work>
    void transact(Work work);
    std::int64_t row_of(const SettingsPtr& settings);
    void insert_command(const char* command, std::uint32_t generation,
                        std::optional<std::int64_t> settings, std::optional<double> share);
    void insert_genotype(const char* command, std::uint32_t generation, const GenomePtr& genome);
    void insert(std::uint32_t generation, const ChangeSettings& command);
    void insert(std::uint32_t generation, const InjectGenome& command);
    void insert(std::uint32_t generation, const AddImmigrants& command);
    void insert(std::uint32_t generation, const RescorePopulation& command);
    void insert_population(const Evolution& evolution);
    void insert_novel(const SelectionMemory& memory);
    void insert_generation(const Evolution& evolution);
    void name_simulator(std::uint32_t generation);
    RowRef keep_chosen(const IndividualPtr& individual);
    void remember_as_chosen(const IndividualPtr& individual);
    void insert_grid(const GridNode& grid);
    void replace_kept(const char* role, const std::vector<JudgedIndividual>& creatures);
    void set_fact(const char* name, const std::string& value);

    Database database_;  // first member, since it must outlive its statements
    const EvolutionKinds& kinds_;
    Known known_;
    KeptIndividuals kept_;
    KeptIndividuals chosen_;
    Deflater deflater_;
    Statement insert_settings_;
    Statement insert_command_;
    Statement clear_population_;
    Statement insert_place_;
    Statement clear_novel_;
    Statement insert_novel_;
    Statement insert_generation_;
    Statement insert_births_;
    Statement update_champion_;
    Statement insert_grid_;
    Statement insert_cell_;
    Statement clear_kept_;
    Statement insert_kept_;
    Statement set_fact_;
};

}  // namespace cambrian
