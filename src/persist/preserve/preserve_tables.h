#pragma once

// The tables of a preserve file and their rows. The functions throw DatabaseError.

#include "persist/preserve/kept_genotypes.h"
#include "persist/preserve/preserve_file.h"
#include "persist/sqlite/columns.h"
#include "persist/sqlite/database.h"

#include <array>
#include <optional>

namespace cambrian {

// Version 1 has no places of interventions, version 2 no walls, version 3 no museum, version 4 no
// changes of laws, and version 5 no genotypes that are differences.
inline constexpr std::int64_t kPreserveVersion = 6;

inline constexpr std::array kSeriesColumns = {
    Column<SeriesRow>{"tick", &SeriesRow::tick},
    Column<SeriesRow>{"population", &SeriesRow::population},
    Column<SeriesRow>{"lineages", &SeriesRow::lineages},
    Column<SeriesRow>{"births", &SeriesRow::births},
    Column<SeriesRow>{"restocked", &SeriesRow::restocked},
    Column<SeriesRow>{"stillborn", &SeriesRow::stillborn},
    Column<SeriesRow>{"died_of_hunger", &SeriesRow::hunger},
    Column<SeriesRow>{"died_eaten", &SeriesRow::eaten},
    Column<SeriesRow>{"died_of_broken_physics", &SeriesRow::broken_physics},
    Column<SeriesRow>{"light", &SeriesRow::light},
    Column<SeriesRow>{"plants", &SeriesRow::plants},
    Column<SeriesRow>{"flesh", &SeriesRow::flesh},
    Column<SeriesRow>{"stores", &SeriesRow::stores},
    Column<SeriesRow>{"bodies", &SeriesRow::bodies},
    Column<SeriesRow>{"mass", &SeriesRow::mass},
    Column<SeriesRow>{"mass_spread", &SeriesRow::mass_spread},
    Column<SeriesRow>{"parts", &SeriesRow::parts},
    Column<SeriesRow>{"parts_spread", &SeriesRow::parts_spread},
    Column<SeriesRow>{"speed", &SeriesRow::speed},
    Column<SeriesRow>{"speed_spread", &SeriesRow::speed_spread},
    Column<SeriesRow>{"diet", &SeriesRow::diet},
    Column<SeriesRow>{"diet_spread", &SeriesRow::diet_spread},
    Column<SeriesRow>{"age", &SeriesRow::age},
};

// A life as a row; energies are in J.
struct LifeRow {
    std::uint64_t number = 0, uid = 0, parent1 = 0, parent2 = 0, lineage = 0;
    std::string method;
    std::uint32_t mutations = 0;
    std::uint64_t born = 0, died = 0;  // ticks
    std::string cause;
    double x = 0.0, y = 0.0, mass = 0.0;
    std::uint32_t parts = 0, neurons = 0;
    double diet = 0.0, eaten_plants = 0.0, eaten_flesh = 0.0, bitten = 0.0, lost = 0.0;
    std::uint32_t children = 0;
};
inline constexpr std::array kLifeColumns = {
    Column<LifeRow>{"number", &LifeRow::number},
    Column<LifeRow>{"uid", &LifeRow::uid, CellForm::kUid},
    Column<LifeRow>{"parent1", &LifeRow::parent1},
    Column<LifeRow>{"parent2", &LifeRow::parent2},
    Column<LifeRow>{"lineage", &LifeRow::lineage},
    Column<LifeRow>{"method", &LifeRow::method},
    Column<LifeRow>{"mutations", &LifeRow::mutations},
    Column<LifeRow>{"born", &LifeRow::born},
    Column<LifeRow>{"died", &LifeRow::died},
    Column<LifeRow>{"cause", &LifeRow::cause},
    Column<LifeRow>{"x", &LifeRow::x},
    Column<LifeRow>{"y", &LifeRow::y},
    Column<LifeRow>{"mass", &LifeRow::mass},
    Column<LifeRow>{"parts", &LifeRow::parts},
    Column<LifeRow>{"neurons", &LifeRow::neurons},
    Column<LifeRow>{"diet", &LifeRow::diet},
    Column<LifeRow>{"eaten_plants", &LifeRow::eaten_plants},
    Column<LifeRow>{"eaten_flesh", &LifeRow::eaten_flesh},
    Column<LifeRow>{"bitten", &LifeRow::bitten},
    Column<LifeRow>{"lost", &LifeRow::lost},
    Column<LifeRow>{"children", &LifeRow::children},
};
LifeRow row_of(const Life& life);

// Bytes of the largest snapshot that is read or written.
inline constexpr int kMostSnapshotBytes = 128'000'000;

void create_preserve_tables(Database& database);
// Fails with a sentence if the database is not a preserve that this program reads.
Status check_preserve_tables(const Database& database);
// Brings tables of an earlier version to that of this program.
void upgrade_preserve_tables(Database& database);

// Writes rows of one file.
class PreserveWriter {
public:
    PreserveWriter(Database& database, const EvolutionKinds& kinds);

    void begin(const PreserveOrigin& origin);
    void write(const Chronicle& chronicle, const Preserve& preserve);
    void put_pins(const Pins& pins);
    // Goes back to a snapshot.
    void remove_after(const PreserveState& state);

private:
    void put_founder(std::size_t number, const GenomePtr& genome);
    void put_genotype(const Life& life);
    void put_life(const Life& life);
    void put_snapshot(const PreserveState& state);
    void thin_snapshots(std::uint64_t tick);

    Database& database_;
    const EvolutionKinds& kinds_;
    Statement put_life_, put_genotype_, put_founder_, put_series_, put_intervention_, put_snapshot_,
        put_piece_;
    GenotypePacker packer_;
    KeptGenotypes genotypes_;
};

// Returns the ticks of all snapshots, in ascending order.
std::vector<std::uint64_t> read_snapshot_ticks(const Database& database);
std::vector<SeriesRow> read_series(const Database& database);
std::vector<MuseumPiece> read_museum(const Database& database, const EvolutionKinds& kinds);
inline constexpr const char* kPinsFact = "pins";
// Returns no pins if it has none, and nothing if they cannot be read.
std::optional<Pins> read_pins(const Database& database);
SavedPreserve read_preserve(const Database& database, const EvolutionKinds& kinds);
Result<PreserveState> read_snapshot(const Database& database, const SnapshotEntry& entry,
                                    const EvolutionKinds& kinds);

}  // namespace cambrian
