#include "fuzz/experiment_sample.h"

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "fuzz/fuzz_target.h"
#include "genome/genome.h"
#include "persist/experiment/experiment_file.h"
#include "persist/settings/settings_file.h"
#include "persist/sqlite/database.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

namespace cambrian::test {
namespace {

constexpr std::uint32_t kGenerations = 2;

// Returns a small genome, two bars and a neuron, because it is read each time.
GenomePtr founder() {
    Genome genome;
    genome.nodes.resize(2);
    genome.nodes[0].edges.emplace_back().target = 1;
    genome.nodes[1].neurons.resize(1);
    repair(genome, kinds().creature.catalog);
    return std::make_shared<const Genome>(std::move(genome));
}

// The settings are short for the same reason.
constexpr const char* kSettings =
    "run.seed = 5\npopulation.size = 2\nselection.method = \"novelty\"\n"
    "trial.duration = 0.1\ntrial.settle-limit = 0.1\n";

ExperimentSettings sample_settings() {
    const auto settings = parse_settings(kSettings, "sample", kinds());
    promise(settings.has_value(), "the sample's settings can be read");
    return *settings;
}

void write_generations(Evolution& evolution, ExperimentFile& file) {
    const auto backend = make_thread_pool_backend(kinds(), 1);
    EvaluationProgress progress;
    while (evolution.history().size() < kGenerations) {
        if (evolution.evaluated()) evolution.breed();
        promise(evolution.evaluate(*backend, progress, {}) && file.record(evolution),
                "a generation can be kept");
    }
}

void write_commands(const SettingsPtr& settings, ExperimentFile& file) {
    promise(file.note({kGenerations - 1, InjectGenome{founder()}}) &&
                file.note({kGenerations - 1, AddImmigrants{0.3}}) &&
                file.note({kGenerations, ChangeSettings{settings}}),
            "commands can be kept");
}

// Writes two grids, the second bred from the first, a shelf and a star.
void write_choices(const Evolution& evolution, ExperimentFile& file) {
    PickingRecord record;
    GridNode node;
    node.settings = evolution.shared_settings();
    node.creatures = evolution.population();
    node.origin = GridOrigin::kPopulation;
    record.tree.add(node);
    node.origin = GridOrigin::kBreeding;
    node.picks = {1, 2};
    record.tree.add(node);
    record.picks = {0};
    record.shelf = {{0, evolution.population()[1], evolution.shared_settings()}};
    promise(file.keep_picking(record) &&
                file.keep_stars({{1, evolution.population()[0], evolution.shared_settings()}}),
            "choices can be kept");
}

void write_sample(const std::filesystem::path& path) {
    const auto settings = std::make_shared<const ExperimentSettings>(sample_settings());
    const std::vector<GenomePtr> founders = {founder()};
    const auto file = ExperimentFile::create(kinds(), settings, founders);
    promise(file.has_value(), "an experiment can be kept");
    Evolution evolution(settings, kinds(), founders);
    write_generations(evolution, **file);
    write_commands(settings, **file);
    write_choices(evolution, **file);
    promise((*file)->move_to(path).has_value(), "an experiment can be moved");
}

}  // namespace

std::string sample_experiment(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / "sample.cambrian";
    write_sample(path);
    {
        Database database(path, Database::Access::kWrite);
        database.prepare("UPDATE settings SET toml = ?").run(kSettings);
        database.execute("INSERT OR IGNORE INTO novel SELECT * FROM population LIMIT 1");
        database.execute("PRAGMA journal_mode = DELETE; PRAGMA page_size = 512; VACUUM");
    }
    return get_text(path);
}

}  // namespace cambrian::test
