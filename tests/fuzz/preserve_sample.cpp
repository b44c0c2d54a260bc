#include "fuzz/preserve_sample.h"

#include "fuzz/fuzz_target.h"
#include "genome/genome.h"
#include "persist/preserve/preserve_file.h"
#include "persist/settings/settings_file.h"
#include "persist/sqlite/database.h"
#include "preserve/preserve.h"
#include "simulator/simulator_version.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace cambrian::test {
namespace {

// The settings are short, and the world is small, because both are read each time.
constexpr const char* kSettings =
    "run.seed = 5\npreserve.width = 6\npreserve.height = 6\npreserve.energy-density = 20\n"
    "preserve.founders = 2\npreserve.restock = 2\npreserve.ramming = 4\n";

template <class Entries>
std::uint8_t index_of(const Entries& entries, std::string_view id) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const auto& entry) { return entry.id == id; });
    promise(found != entries.end(), "the sample's kinds are known");
    return static_cast<std::uint8_t>(found - entries.begin());
}

// Returns a small genome, which is read each time: two bars that swing, and a mouth.
GenomePtr founder() {
    const KindCatalog& catalog = kinds().creature.catalog;
    Genome genome;
    genome.nodes.resize(2);
    NodeGene& head = genome.nodes[0];
    head.edges.emplace_back().target = 1;
    head.organs.push_back({.kind = index_of(catalog.organs, "mouth"), .parameters = {0.5, 0.0}});
    NodeGene& tail = genome.nodes[1];
    tail.neurons.push_back({index_of(catalog.functions, "oscillate-wave"), {{{}, 1.0}, {{}, 0.0}}});
    tail.effector = {{.kind = SourceKind::kLocalNeuron}, 0.6};
    repair(genome, catalog);
    return std::make_shared<const Genome>(std::move(genome));
}

void write_preserve(const std::filesystem::path& path) {
    Result<ExperimentSettings> read =
        parse_settings(kSettings, "sample", kinds(), SettingsUse::kPreserve);
    promise(read.has_value(), "the sample's settings can be read");
    const auto settings = std::make_shared<const ExperimentSettings>(*std::move(read));
    const std::vector<GenomePtr> founders = {founder()};
    auto preserve = Preserve::begin(settings, kinds(), founders);
    promise(preserve.has_value(), "a preserve can begin");
    auto file = PreserveFile::create(path, {settings, founders, std::string(kSimulatorVersion)},
                                     (*preserve)->take_chronicle(), **preserve, kinds());
    promise(file.has_value(), "a preserve can be kept");
    ThreadPool pool(1);
    while ((*preserve)->ticks() < kTicksPerSnapshot)
        (*preserve)->tick(pool);
    Chronicle chronicle = (*preserve)->take_chronicle();
    chronicle.interventions.push_back({1, "restock", 1});
    chronicle.interventions.push_back({.tick = 1, .what = "law mutation.rate", .x = 2.0});
    chronicle.museum.push_back({1, 1, museum_reason::kLineage, kMembersForMuseum});
    // A child, whose genotype is kept as a difference.
    const std::uint64_t child = 99;
    chronicle.born.push_back({.number = child, .parents = {1, 0}, .genome = founders.front()});
    chronicle.museum.push_back({child, 1, museum_reason::kChildren, 1});
    promise((*file)->write(chronicle, **preserve).has_value(), "a snapshot can be kept");
}

}  // namespace

std::string sample_preserve(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / "sample.cambrian";
    write_preserve(path);
    {
        Database database(path, Database::Access::kWrite);
        database.prepare("UPDATE facts SET value = ? WHERE name = 'settings'").run(kSettings);
        database.execute("PRAGMA journal_mode = DELETE; PRAGMA page_size = 512; VACUUM");
    }
    return get_text(path);
}

}  // namespace cambrian::test
