#include "persist/experiment/experiment_reader.h"

#include "core/text/parsed_number.h"
#include "core/text/shown_text.h"
#include "evolution/individual/population_digest.h"
#include "persist/experiment/injection_places.h"
#include "persist/records/experiment_schema.h"
#include "persist/records/individual_reader.h"
#include "persist/records/kept_opponents.h"
#include "persist/records/statistics_columns.h"
#include "persist/settings/settings_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kLargestPopulation = 100'000;
constexpr std::size_t kMostSettings = 100'000;  // bytes of one settings text
constexpr std::int64_t kLeastRow = 8;           // least bytes per row, approximately
constexpr std::size_t kMostGridCells = 25;

template <std::size_t Count>
std::size_t index_of(std::string_view name, const std::array<std::string_view, Count>& names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw DatabaseError(in_quotes(name) + " is not known");
    return static_cast<std::size_t>(found - names.begin());
}

// An upper bound of the number of rows in a file of this size. Damaged tables can repeat rows
// endlessly.
std::size_t most_rows(const Database& database) {
    const std::int64_t bytes =
        database.integer("PRAGMA page_count") * database.integer("PRAGMA page_size");
    return static_cast<std::size_t>(bytes / kLeastRow);
}

double share_of(const Statement& row, int column) {
    const double share = row.real(column);
    if (share >= 0.0 && share <= 1.0) return share;
    throw DatabaseError("a share of newcomers is outside [0, 1]");
}

// Generations must be numbered from 0 without a gap.
void check_order(const GenerationStatistics& statistics, std::size_t expected) {
    if (statistics.generation != expected)
        throw DatabaseError(fmt::format("generation {} is missing", expected));
}

// Adds the births of each line to the history of generations that have none yet.
void read_births(const Database& database, std::vector<GenerationStatistics>& history) {
    Statement row =
        database.prepare("SELECT generation, line, births FROM births ORDER BY generation, line");
    const std::size_t most = most_rows(database);
    std::size_t count = 0;
    while (row.step()) {
        std::uint32_t generation = 0;
        LineBirths line;
        read_column(row, 0, generation);
        read_column(row, 1, line.line);
        read_column(row, 2, line.births);
        if (generation >= history.size() || line.births < 0)
            throw DatabaseError("births of a generation that is missing");
        history[generation].births.push_back(line);
        if (++count > most) throw DatabaseError("it is damaged: more births than it can hold");
    }
    for (GenerationStatistics& generation : history)
        put_most_first(generation.births);
}

RowRef row_ref(const Statement& row, int column) {
    return {row.integer(column), row.integer(column + 1)};
}

SettingsPtr read_settings(const Database& database, std::int64_t id, const EvolutionKinds& kinds) {
    Statement row = database.prepare("SELECT toml FROM settings WHERE id = ?");
    row.bind(id);
    const std::string name = fmt::format("settings {}", id);
    if (!row.step()) throw DatabaseError(name + " are missing");
    Result<ExperimentSettings> parsed = parse_settings(row.text(0, kMostSettings), name, kinds);
    if (!parsed) throw DatabaseError(parsed.error().message);
    parsed->world.opponents = read_opponents(database, id, kinds);
    return std::make_shared<const ExperimentSettings>(std::move(*parsed));
}

class ExperimentReader {
public:
    ExperimentReader(const Database& database, const EvolutionKinds& kinds)
        : database_(database),
          kinds_(kinds),
          most_rows_(most_rows(database)),
          individuals_(database, kinds),
          genotypes_(kinds) {}

    ReadExperiment read() {
        read_simulators();
        read_journal();
        read_generations();
        if (read_.saved.latest) read_latest();
        read_grids();
        read_.picking.shelf = kept("shelf");
        read_.stars = kept("star");
        return std::move(read_);
    }

private:
    // A row of the journal with settings.
    struct Change {
        bool is_start = false;
        std::int64_t settings = 0;  // their row
        std::uint32_t generation = 0;
    };

    SettingsPtr settings(std::int64_t id) {
        SettingsPtr& place = settings_[id];
        if (!place) place = read_settings(database_, id, kinds_);
        return place;
    }

    GenomePtr genotype(const Statement& row, int column) {
        Result<GenomePtr> genome = genotypes_.read(row.bytes(column + 1), row.integer(column));
        if (!genome) throw DatabaseError(genome.error().message);
        return *genome;
    }

    void read_simulators() {
        Statement row =
            database_.prepare("SELECT generation, version FROM simulators ORDER BY generation");
        std::vector<SimulatorChange>& simulators = read_.saved.simulators;
        while (row.step()) {
            SimulatorChange change;
            read_column(row, 0, change.generation);
            change.version = row.word(1);
            if (!simulators.empty() && change.generation <= simulators.back().generation)
                throw DatabaseError("a generation has two simulators");
            simulators.push_back(std::move(change));
        }
        if (simulators.empty() || simulators.front().generation != 0)
            throw DatabaseError("the simulator that computed generation 0 is missing");
    }

    void read_journal() {
        read_places();
        Statement row = database_.prepare(
            "SELECT generation, command, settings, share, size, genotype FROM journal ORDER BY id");
        std::size_t commands = 0;
        const std::int64_t present =
            database_.integer("SELECT ifnull(max(generation) + 1, 0) FROM generations");
        while (row.step()) {
            check_count(++commands, "commands");
            std::uint32_t generation = 0;
            read_column(row, 0, generation);
            if (generation > present) {
                throw DatabaseError(fmt::format(
                    "a command was given in generation {}, which was never reached", generation));
            }
            read_command(row, generation);
        }
        if (!read_.saved.settings) throw DatabaseError("the journal has no beginning");
    }

    void read_places() {
        // Every row is counted before settings are read, so that an endless table is refused.
        Statement row =
            database_.prepare("SELECT generation, command, settings FROM journal ORDER BY id");
        std::size_t commands = 0;
        std::vector<Change> changes;  // includes the settings at the start
        while (row.step()) {
            check_count(++commands, "commands");
            const bool is_start = row.text(1) == "start";
            if (!is_start && row.text(1) != "settings") continue;
            if (std::ssize(changes) > kMostSettingsChanges)
                throw DatabaseError(
                    fmt::format("more than {} changes of settings", kMostSettingsChanges));
            Change& change = changes.emplace_back(Change{is_start, row.integer(2)});
            read_column(row, 0, change.generation);
        }
        for (const Change& change : changes) {
            const SettingsPtr present = settings(change.settings);
            if (change.is_start) places_.begin(*present);
            places_.change(change.generation, *present);
        }
    }

    void read_command(const Statement& row, std::uint32_t generation) {
        const std::string_view command = row.text(1);
        std::vector<NotedCommand>& journal = read_.saved.journal;
        if ((command == "start") == (read_.saved.settings != nullptr))
            throw DatabaseError("the journal has no beginning, or two");
        if (command == "start") {
            read_.saved.settings = settings(row.integer(2));
        } else if (command == "founder") {
            if (read_.saved.founders.size() < places_.founders())
                read_.saved.founders.push_back(genotype(row, 4));
        } else if (command == "settings") {
            journal.push_back({generation, ChangeSettings{settings(row.integer(2))}});
        } else if (command == "inject") {
            if (places_.take(generation))
                journal.push_back({generation, InjectGenome{genotype(row, 4)}});
        } else if (command == "newcomers") {
            journal.push_back({generation, AddImmigrants{share_of(row, 3)}});
        } else if (command == "rescore") {
            journal.push_back({generation, RescorePopulation{}});
        } else {
            throw DatabaseError("unknown command " + in_quotes(command));
        }
    }

    void read_generations() {
        const int more = static_cast<int>(kStatisticsColumns.size());
        Statement row = database_.prepare(
            fmt::format("SELECT {}, champion, champion_judged, settings, population_digest, "
                        "audited, audited_survivors, novelty_threshold, novelty_quiet, {} FROM "
                        "generations ORDER BY generation",
                        column_names<GenerationStatistics>(kStatisticsColumns),
                        column_names<GenerationStatistics>(kLaterStatisticsColumns)));
        EvolutionState latest;
        while (row.step()) {
            GenerationStatistics statistics;
            read_columns<GenerationStatistics>(row, 0, kStatisticsColumns, statistics);
            check_order(statistics, latest.history.size());
            read_columns<GenerationStatistics>(row, more + 8, kLaterStatisticsColumns, statistics);
            latest.history.push_back(statistics);
            latest.generation = statistics.generation;
            latest.settings = settings(row.integer(more + 2));
            latest.history.back().terrain_level = latest.settings->world.environment.terrain.level;
            read_.saved.champions.push_back({statistics.generation,
                                             champion(row_ref(row, more), *latest.settings),
                                             latest.settings});
            read_.saved.digests.push_back(static_cast<std::uint64_t>(row.integer(more + 3)));
            read_column(row, more + 4, latest.termination_audit.finished);
            read_column(row, more + 5, latest.termination_audit.survived);
            latest.memory.threshold = row.real(more + 6);
            read_column(row, more + 7, latest.memory.quiet_generations);
        }
        read_births(database_, latest.history);
        if (!latest.history.empty()) read_.saved.latest = std::move(latest);
    }

    // An audited champion has scores of its own, as those that were chosen have.
    IndividualPtr champion(const RowRef& row, const ExperimentSettings& settings) {
        return row.judged < 0 ? chosen(row, settings) : individuals_.read(row, settings);
    }

    void read_latest() {
        EvolutionState& latest = *read_.saved.latest;
        Statement place =
            database_.prepare("SELECT individual, judged FROM population ORDER BY place");
        while (place.step()) {
            read_.population.push_back(row_ref(place, 0));
            latest.population.push_back(
                individuals_.read(read_.population.back(), *latest.settings));
            if (latest.population.size() > kLargestPopulation)
                throw DatabaseError("the population is too large");
        }
        Statement novel = database_.prepare("SELECT individual, judged FROM novel ORDER BY place");
        while (novel.step()) {
            latest.memory.archive.push_back(individuals_.read(row_ref(novel, 0), *latest.settings));
            check_count(latest.memory.archive.size(), "novel creatures");
        }
        if (latest.population.empty() ||
            population_digest(latest.population) != read_.saved.digests.back())
            throw DatabaseError("the latest population is not the one that was written");
    }

    IndividualPtr chosen(const RowRef& row, const ExperimentSettings& settings) {
        IndividualPtr individual = individuals_.read(row, settings);
        read_.chosen.emplace_back(individual, row);
        return individual;
    }

    void read_grids() {
        Statement row = database_.prepare(
            "SELECT parent, origin, cells, boldness, fitness_weight, generations, settings, "
            "picks, number FROM grids ORDER BY number");
        PickingTree& tree = read_.picking.tree;
        while (row.step()) {
            if (row.integer(8) != static_cast<std::int64_t>(tree.size()))
                throw DatabaseError(fmt::format("grid {} is missing", tree.size()));
            if (row.is_null(0) != tree.empty()) throw DatabaseError("a grid has no parent");
            if (!tree.empty()) {
                std::uint32_t parent = 0;
                read_column(row, 0, parent);
                if (!tree.visit(parent)) throw DatabaseError("a grid's parent is missing");
            }
            tree.add(grid(row, static_cast<std::uint32_t>(tree.size())));
        }
        if (!tree.empty()) read_place();
    }

    GridNode grid(const Statement& row, std::uint32_t number) {
        GridNode node;
        node.origin = static_cast<GridOrigin>(index_of(row.text(1), kOriginNames));
        read_column(row, 2, node.grid.cells);
        node.grid.boldness = static_cast<Boldness>(index_of(row.text(3), kBoldnessNames));
        node.grid.fitness_weight = row.real(4);
        read_column(row, 5, node.generations);
        node.settings = settings(row.integer(6));
        if (const Status valid = check_grid(node.grid); !valid)
            throw DatabaseError(valid.error().message);
        Statement cell = database_.prepare(
            "SELECT individual, judged FROM grid_cells WHERE grid = ? ORDER BY cell LIMIT 100");
        cell.bind(number);
        while (cell.step())
            node.creatures.push_back(chosen(row_ref(cell, 0), *node.settings));
        if (node.creatures.empty()) throw DatabaseError("a grid is empty");
        const PickingTree& tree = read_.picking.tree;
        node.picks =
            picks(row.text(7), tree.empty() ? kMostGridCells : tree.current().creatures.size());
        return node;
    }

    static std::vector<std::size_t> picks(std::string_view text, std::size_t cells) {
        const auto picks = parse_picks(text);
        if (!picks || std::any_of(picks->begin(), picks->end(),
                                  [cells](std::size_t cell) { return cell >= cells; }))
            throw DatabaseError(in_quotes(text) + " are no picks");
        return *picks;
    }

    // Reads the number of the present grid and its picks.
    void read_place() {
        const auto shown = fact("grid_on_show");
        PickingTree& tree = read_.picking.tree;
        const auto number = parsed_number<std::uint32_t>(shown);
        if (!number || !tree.visit(*number)) throw DatabaseError("the displayed grid is missing");
        read_.picking.picks = picks(fact("picks_on_show"), tree.current().creatures.size());
    }

    void check_count(std::size_t count, const char* what) const {
        if (count <= most_rows_) return;
        throw DatabaseError(fmt::format("it is damaged: more {} than it can hold", what));
    }

    std::string fact(const char* name) {
        Statement row = database_.prepare("SELECT value FROM facts WHERE name = ?");
        row.bind(name);
        return row.step() ? std::string(row.text(0)) : std::string();
    }

    std::vector<JudgedIndividual> kept(const char* role) {
        std::vector<JudgedIndividual> creatures;
        Statement row = database_.prepare(
            "SELECT individual, judged, generation, settings FROM kept WHERE role = ? "
            "ORDER BY place");
        row.bind(role);
        while (row.step()) {
            JudgedIndividual each;
            read_column(row, 2, each.generation);
            each.settings = settings(row.integer(3));
            each.individual = chosen(row_ref(row, 0), *each.settings);
            creatures.push_back(std::move(each));
            check_count(creatures.size(), "kept creatures");
        }
        return creatures;
    }

    const Database& database_;
    const EvolutionKinds& kinds_;
    std::size_t most_rows_;
    IndividualReader individuals_;
    GenotypeReader genotypes_;
    std::map<std::int64_t, SettingsPtr> settings_;
    InjectionPlaces places_;
    ReadExperiment read_;
};

}  // namespace

ReadExperiment read_experiment(const Database& database, const EvolutionKinds& kinds) {
    return ExperimentReader(database, kinds).read();
}

SettingsPtr read_last_settings(const Database& database, const EvolutionKinds& kinds) {
    Statement row = database.prepare(
        "SELECT settings FROM journal WHERE id = (SELECT max(id) FROM "
        "(SELECT id, command FROM journal ORDER BY id DESC LIMIT ?) "
        "WHERE command IN ('start', 'settings'))");
    row.bind(std::uint64_t{most_rows(database)});
    if (!row.step()) throw DatabaseError("the journal has no beginning");
    return read_settings(database, row.integer(0), kinds);
}

JudgedIndividual read_champion(const Database& database, std::uint32_t generation,
                               const EvolutionKinds& kinds) {
    Statement row = database.prepare(
        "SELECT champion, champion_judged, settings FROM generations WHERE generation = ?");
    row.bind(std::uint64_t{generation});
    if (!row.step()) throw DatabaseError(fmt::format("generation {} is missing", generation));
    const SettingsPtr settings = read_settings(database, row.integer(2), kinds);
    return {generation, IndividualReader(database, kinds).read(row_ref(row, 0), *settings),
            settings};
}

std::optional<std::string> read_only_simulator(const Database& database) {
    Statement row = database.prepare("SELECT version, generation FROM simulators LIMIT 2");
    if (!row.step() || row.integer(1) != 0) return std::nullopt;
    std::string version = row.word(0);
    return row.step() ? std::nullopt : std::optional(std::move(version));
}

std::vector<GenerationStatistics> read_history(const Database& database) {
    Statement row =
        database.prepare(fmt::format("SELECT {}, {} FROM generations ORDER BY generation",
                                     column_names<GenerationStatistics>(kStatisticsColumns),
                                     column_names<GenerationStatistics>(kLaterStatisticsColumns)));
    std::vector<GenerationStatistics> history;
    while (row.step()) {
        GenerationStatistics& statistics = history.emplace_back();
        const int next = read_columns<GenerationStatistics>(row, 0, kStatisticsColumns, statistics);
        read_columns<GenerationStatistics>(row, next, kLaterStatisticsColumns, statistics);
        check_order(statistics, history.size() - 1);
    }
    read_births(database, history);
    return history;
}

}  // namespace cambrian
