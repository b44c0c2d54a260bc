#include "persist/records/kept_opponents.h"

#include "evolution/individual/judged_individual.h"
#include "persist/creature/creature_format.h"
#include "persist/creature/genotype_text.h"

namespace cambrian {
namespace {

bool has_table(const Database& database) {
    return database.integer(
               "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name = 'opponents'") >
           0;
}

}  // namespace

void write_opponents(Database& database, std::int64_t settings_row, const Opponents& opponents,
                     const EvolutionKinds& kinds) {
    if (opponents.genomes.empty()) return;
    database.execute(
        "CREATE TABLE IF NOT EXISTS opponents (settings INTEGER NOT NULL, trial INTEGER NOT NULL, "
        "size INTEGER NOT NULL, document BLOB NOT NULL, PRIMARY KEY (settings, trial)) "
        "WITHOUT ROWID");
    Statement insert = database.prepare("INSERT INTO opponents VALUES (?, ?, ?, ?)");
    GenotypePacker packer(kinds);
    for (std::size_t trial = 0; trial < opponents.genomes.size(); ++trial) {
        const JudgedIndividual opponent = unjudged(opponents.genomes[trial]);
        const PackedGenotype packed = packer.pack(*opponent.individual);
        insert.bind(settings_row, std::uint64_t{trial}, std::uint64_t{packed.size});
        insert.bind_bytes(packed.bytes);
        insert.finish();
    }
}

Opponents read_opponents(const Database& database, std::int64_t settings_row,
                         const EvolutionKinds& kinds) {
    Opponents opponents;
    if (!has_table(database)) return opponents;
    Statement row = database.prepare(
        "SELECT size, document FROM opponents WHERE settings = ? ORDER BY trial LIMIT ?");
    row.bind(settings_row, std::uint64_t{creature_format::kMostOpponents});
    GenotypeReader reader(kinds);
    while (row.step()) {
        Result<GenomePtr> genome = reader.read(row.bytes(1), row.integer(0));
        if (!genome) throw DatabaseError(genome.error().message);
        opponents.genomes.push_back(*genome);
    }
    return opponents;
}

}  // namespace cambrian
