#include "persist/experiment/experiment_writer.h"

#include "evolution/individual/population_digest.h"
#include "persist/creature/creature_file.h"
#include "persist/records/experiment_schema.h"
#include "persist/records/kept_opponents.h"
#include "persist/settings/settings_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMoreGenerationColumns = 8;  // columns besides the statistics

}  // namespace

ExperimentWriter::ExperimentWriter(Database database, const EvolutionKinds& kinds)
    : database_(std::move(database)),
      kinds_(kinds),
      kept_(database_, kinds, known_.individuals),
      chosen_(database_, kinds, known_.chosen),
      insert_settings_(database_.prepare("INSERT INTO settings (toml) VALUES (?)")),
      insert_command_(
          database_.prepare("INSERT INTO journal (generation, command, settings, share, size, "
                            "genotype) VALUES (?, ?, ?, ?, ?, ?)")),
      clear_population_(database_.prepare("DELETE FROM population")),
      insert_place_(database_.prepare("INSERT INTO population VALUES (?, ?, ?)")),
      clear_novel_(database_.prepare("DELETE FROM novel")),
      insert_novel_(database_.prepare("INSERT INTO novel VALUES (?, ?, ?)")),
      insert_generation_(database_.prepare(
          fmt::format("INSERT INTO generations VALUES (?{})",
                      more_places(kStatisticsColumns.size() + kMoreGenerationColumns +
                                  kLaterStatisticsColumns.size() - 1)))),
      insert_births_(database_.prepare("INSERT INTO births VALUES (?, ?, ?)")),
      update_champion_(database_.prepare("UPDATE generations SET champion = ?, champion_judged = ? "
                                         "WHERE generation = ?")),
      insert_grid_(
          database_.prepare(fmt::format("INSERT INTO grids VALUES (?{})", more_places(8)))),
      insert_cell_(database_.prepare("INSERT INTO grid_cells VALUES (?, ?, ?, ?)")),
      clear_kept_(database_.prepare("DELETE FROM kept WHERE role = ?")),
      insert_kept_(database_.prepare("INSERT INTO kept VALUES (?, ?, ?, ?, ?, ?)")),
      set_fact_(database_.prepare("INSERT OR REPLACE INTO facts VALUES (?, ?)")) {}

void ExperimentWriter::remember(const ReadExperiment& read) {
    for (const auto& [individual, row] : read.chosen) {
        chosen_.remember(individual, row, true);
        chosen_.hold_score(individual);
    }
    known_.outside_scores = database_.integer("SELECT min(0, ifnull(min(judged), 0)) FROM results");
    known_.grids = read.picking.tree.size();
    known_.simulator = read.saved.simulators.back().version;
    if (!read.saved.latest) return;
    const EvolutionState& latest = *read.saved.latest;
    for (std::size_t i = 0; i < read.population.size(); ++i) {
        const IndividualPtr& individual = latest.population[i];
        kept_.remember(individual, read.population[i], individual->born < latest.generation);
    }
    for (const JudgedIndividual& champion : read.saved.champions)
        kept_.hold_score(champion.individual);
    for (const auto& [individual, row] : read.chosen)
        kept_.hold_score(individual);
    for (const IndividualPtr& novel : latest.memory.archive)
        kept_.hold_score(novel);
    known_.novel = latest.memory.archive;
}

// Runs work in a transaction. A failure changes neither the file nor the record of its contents.
template <class Work>
void ExperimentWriter::transact(Work work) {
    Transaction transaction(database_);
    Known before = known_;
    try {
        work();
        transaction.commit();
    } catch (...) {
        known_ = std::move(before);
        throw;
    }
}

void ExperimentWriter::begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders) {
    transact([&] {
        insert_command("start", 0, row_of(settings), std::nullopt);
        for (const GenomePtr& founder : founders)
            insert_genotype("founder", 0, founder);
        name_simulator(0);
    });
}

void ExperimentWriter::note(const NotedCommand& noted) {
    transact([&] {
        std::visit([&](const auto& command) { insert(noted.generation, command); }, noted.command);
    });
}

void ExperimentWriter::record(const Evolution& evolution) {
    transact([&] {
        insert_population(evolution);
        insert_novel(evolution.selection_memory());
        kept_.hold_score(evolution.population().front());
        insert_generation(evolution);
        name_simulator(evolution.generation());
        kept_.drop_others(evolution.population());
    });
}

// The audit's scores are further ones of a creature of the population, which keeps its own.
void ExperimentWriter::crown(const JudgedIndividual& champion) {
    transact([&] {
        const auto living = known_.individuals.find(champion.individual->uid);
        if (living != known_.individuals.end()) remember_as_chosen(living->second.individual);
        const RowRef row = keep_chosen(champion.individual);
        update_champion_.run(row.individual, row.judged, champion.generation);
    });
}

void ExperimentWriter::keep_picking(const PickingRecord& picking) {
    transact([&] {
        if (picking.tree.size() < known_.grids) {
            database_.execute("DELETE FROM grids; DELETE FROM grid_cells");
            known_.grids = 0;
        }
        for (; known_.grids < picking.tree.size(); ++known_.grids)
            insert_grid(picking.tree.node(static_cast<std::uint32_t>(known_.grids)));
        replace_kept("shelf", picking.shelf);
        if (picking.tree.empty()) return;
        set_fact("grid_on_show", std::to_string(picking.tree.current().number));
        set_fact("picks_on_show", picks_text(picking.picks));
    });
}

void ExperimentWriter::keep_stars(const std::vector<JudgedIndividual>& stars) {
    transact([&] { replace_kept("star", stars); });
}

// Creatures of the population keep their rows and scores; others get new ones.
RowRef ExperimentWriter::keep_chosen(const IndividualPtr& individual) {
    const auto living = known_.individuals.find(individual->uid);
    if (living != known_.individuals.end() && living->second.individual == individual)
        remember_as_chosen(individual);
    const RowRef row = chosen_.keep(individual, known_.outside_scores - 1);
    known_.outside_scores = std::min(known_.outside_scores, row.judged);
    chosen_.hold_score(individual);
    return row;
}

// The creature must be of the population, with the same scores.
void ExperimentWriter::remember_as_chosen(const IndividualPtr& individual) {
    kept_.hold_score(individual);
    chosen_.remember(individual, kept_.row_of(*individual), true);
    chosen_.hold_score(individual);
}

void ExperimentWriter::insert_grid(const GridNode& grid) {
    insert_grid_.run(grid.number, grid.parent, kOriginNames[static_cast<std::size_t>(grid.origin)],
                     grid.grid.cells, kBoldnessNames[static_cast<std::size_t>(grid.grid.boldness)],
                     grid.grid.fitness_weight, grid.generations, row_of(grid.settings),
                     picks_text(grid.picks));
    for (std::size_t cell = 0; cell < grid.creatures.size(); ++cell) {
        const RowRef row = keep_chosen(grid.creatures[cell]);
        insert_cell_.run(grid.number, std::uint64_t{cell}, row.individual, row.judged);
    }
}

void ExperimentWriter::replace_kept(const char* role,
                                    const std::vector<JudgedIndividual>& creatures) {
    clear_kept_.run(role);
    std::uint64_t place = 0;
    for (const JudgedIndividual& each : creatures) {
        const RowRef row = keep_chosen(each.individual);
        insert_kept_.run(role, place++, row.individual, row.judged, each.generation,
                         row_of(each.settings));
    }
}

// Records this program's simulator version from this generation on, unless it is recorded.
void ExperimentWriter::name_simulator(std::uint32_t generation) {
    const std::string_view present = simulator_version(kinds_.creature.scene.dimensions);
    if (known_.simulator == present) return;
    database_.prepare("INSERT OR REPLACE INTO simulators VALUES (?, ?)").run(generation, present);
    known_.simulator = present;
}

void ExperimentWriter::set_fact(const char* name, const std::string& value) {
    set_fact_.run(name, value);
}

void ExperimentWriter::copy_to(const std::filesystem::path& path) const {
    database_.copy_to(path);
}

std::int64_t ExperimentWriter::row_of(const SettingsPtr& settings) {
    if (known_.settings && *known_.settings == *settings) return known_.settings_row;
    insert_settings_.run(write_settings(*settings, kinds_));
    known_.settings = settings;
    known_.settings_row = insert_settings_.inserted_row();
    write_opponents(database_, known_.settings_row, settings->world.opponents, kinds_);
    return known_.settings_row;
}

void ExperimentWriter::insert_command(const char* command, std::uint32_t generation,
                                      std::optional<std::int64_t> settings,
                                      std::optional<double> share) {
    insert_command_.run(generation, command, settings, share, std::nullopt, std::nullopt);
}

void ExperimentWriter::insert_genotype(const char* command, std::uint32_t generation,
                                       const GenomePtr& genome) {
    const std::string text = write_creature({unjudged(genome)}, kinds_);
    insert_command_.bind(generation, command, std::nullopt, std::nullopt,
                         std::uint64_t{text.size()});
    insert_command_.bind_bytes(deflater_.deflate(text));
    insert_command_.finish();
}

void ExperimentWriter::insert(std::uint32_t generation, const ChangeSettings& command) {
    if (database_.integer("SELECT count(*) FROM journal WHERE command = 'settings'") >=
        kMostSettingsChanges) {
        throw DatabaseError(fmt::format(
            "it holds {} changes of settings, the most of one experiment; start a new run",
            kMostSettingsChanges));
    }
    insert_command("settings", generation, row_of(command.settings), std::nullopt);
}

void ExperimentWriter::insert(std::uint32_t generation, const InjectGenome& command) {
    insert_genotype("inject", generation, command.genome);
}

void ExperimentWriter::insert(std::uint32_t generation, const AddImmigrants& command) {
    insert_command("newcomers", generation, std::nullopt, command.share);
}

void ExperimentWriter::insert(std::uint32_t generation, const RescorePopulation& /*command*/) {
    insert_command("rescore", generation, std::nullopt, std::nullopt);
}

void ExperimentWriter::insert_population(const Evolution& evolution) {
    clear_population_.run();
    std::uint64_t place = 0;
    for (const IndividualPtr& individual : evolution.population()) {
        const RowRef row = kept_.keep(individual, evolution.generation());
        insert_place_.run(++place, row.individual, row.judged);
    }
}

// Inserts the creatures that became novel when the last generation was bred, or all if the memory
// was emptied.
void ExperimentWriter::insert_novel(const SelectionMemory& memory) {
    const std::vector<IndividualPtr>& archive = memory.archive;
    std::size_t known = known_.novel.size();
    if (archive.size() < known || (known > 0 && archive[known - 1] != known_.novel.back())) {
        clear_novel_.run();
        known = 0;
    }
    for (std::size_t i = known; i < archive.size(); ++i) {
        const RowRef row = kept_.row_of(*archive[i]);
        insert_novel_.run(std::uint64_t{i + 1}, row.individual, row.judged);
        kept_.hold_score(archive[i]);
    }
    known_.novel = archive;
}

void ExperimentWriter::insert_generation(const Evolution& evolution) {
    const RowRef champion = kept_.row_of(*evolution.population().front());
    const SelectionMemory& memory = evolution.selection_memory();
    insert_generation_.restart();
    bind_columns<GenerationStatistics>(insert_generation_, kStatisticsColumns,
                                       evolution.history().back());
    insert_generation_.bind_next(champion.individual);
    insert_generation_.bind_next(champion.judged);
    insert_generation_.bind_next(row_of(evolution.shared_settings()));
    insert_generation_.bind_next(population_digest(evolution.population()));
    insert_generation_.bind_next(evolution.termination_audit().finished);
    insert_generation_.bind_next(evolution.termination_audit().survived);
    insert_generation_.bind_next(memory.threshold);
    insert_generation_.bind_next(memory.quiet_generations);
    bind_columns<GenerationStatistics>(insert_generation_, kLaterStatisticsColumns,
                                       evolution.history().back());
    insert_generation_.finish();
    for (const LineBirths& line : evolution.history().back().births)
        insert_births_.run(evolution.generation(), line.line, line.births);
}

}  // namespace cambrian
