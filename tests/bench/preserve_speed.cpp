// The speed of preserves with more and more creatures at the same density, and their memory.
#include "app/builtin_kinds.h"
#include "bench/write_table.h"
#include "core/random.h"
#include "core/stopwatch.h"
#include "genome/founders/random_genome.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "preserve/preserve.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <malloc.h>
#include <string>
#include <vector>

namespace cambrian::bench {
namespace {

struct Options {
    std::string settings, csv_path;
    std::vector<std::string> files;
    std::vector<std::size_t> creatures{100, 300, 1000};
    std::vector<std::size_t> threads{1, 2};
    std::size_t bodies = 6;
    double seconds = 10.0;  // of each world
    double area = 10.0;     // m^2 for each creature
};

// Processor time of all threads of this program, s.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Bytes that are allocated on the heap.
std::size_t heap_bytes() {
    const struct mallinfo2 heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}

// Returns settings of a world in which nobody is born while all founders live.
SettingsPtr world_of(ExperimentSettings settings, std::size_t creatures, double area) {
    PreserveSettings& laws = settings.preserve;
    const double shape = laws.width / laws.height;
    laws.height = std::sqrt(static_cast<double>(creatures) * area / shape);
    laws.width = shape * laws.height;
    laws.founders = static_cast<int>(creatures);
    laws.max_population = static_cast<int>(creatures);
    laws.restock = 0;
    return std::make_shared<const ExperimentSettings>(std::move(settings));
}

// Returns random creatures of so many bodies that can move.
std::vector<GenomePtr> random_swimmers(const ExperimentSettings& settings,
                                       const EvolutionKinds& kinds, std::size_t bodies) {
    constexpr std::size_t kDifferent = 50;
    RandomStream stream(stream_seed({1994, 20}));
    std::vector<GenomePtr> found;
    while (found.size() < kDifferent) {
        auto genome = std::make_shared<const Genome>(
            random_genome(settings.founders, kinds.creature.catalog, stream));
        const Phenotype body =
            express(*genome, kinds.creature, settings.expression, settings.world.scene);
        if (body.parts.size() == bodies && body.can_move() && body.has_live_control)
            found.push_back(std::move(genome));
    }
    return found;
}

struct Figures {
    double wall = 0.0, processor = 0.0;  // s for each second of the world
    double joined = 0.0;                 // share of the time in which a creature touches others
    double bodies = 0.0;                 // of a creature
    std::size_t left = 0;                // creatures at the end
    double bytes = 0.0;                  // of a creature
};

Result<Figures> measure(const SettingsPtr& settings, const EvolutionKinds& kinds,
                        const std::vector<GenomePtr>& founders, std::size_t threads,
                        double seconds) {
    const std::size_t before = heap_bytes();
    auto begun = Preserve::begin(settings, kinds, founders);
    if (!begun) return begun.error();
    Preserve& preserve = **begun;
    ThreadPool pool(threads);
    preserve.tick(pool);
    const Stopwatch wall;
    const double processor = processor_seconds();
    const auto ticks = static_cast<std::uint64_t>(std::llround(60.0 * seconds));
    for (std::uint64_t tick = 0; tick < ticks; ++tick)
        preserve.tick(pool);
    Figures figures;
    figures.wall = wall.seconds() / seconds;
    figures.processor = (processor_seconds() - processor) / seconds;
    const SolidCounts counts = preserve.solid_counts();
    figures.joined = static_cast<double>(counts.joined_ticks) /
                     static_cast<double>(std::max<std::uint64_t>(counts.ticks, 1));
    figures.left = preserve.residents().size();
    figures.bodies = preserve.row().parts;
    figures.bytes = static_cast<double>(heap_bytes() - before) / static_cast<double>(figures.left);
    return figures;
}

int fail(const Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return 2;
}

int run(const Options& options) {
    const EvolutionKinds kinds = builtin_kinds();
    Result<ExperimentSettings> settings =
        load_settings(options.settings, kinds, SettingsUse::kPreserve);
    if (!settings) return fail(settings.error());
    std::vector<GenomePtr> founders;
    for (const std::string& file : options.files) {
        const Result<CreatureDocument> document = load_creature(file, kinds);
        if (!document) return fail(document.error());
        founders.push_back(std::make_shared<const Genome>(document->genome()));
    }
    if (founders.empty()) founders = random_swimmers(*settings, kinds, options.bodies);
    std::string csv =
        "creatures,bodies,threads,times_real,processor_times_real,joined_percent,kilobytes\n";
    for (const std::size_t creatures : options.creatures) {
        const SettingsPtr world = world_of(*settings, creatures, options.area);
        for (const std::size_t threads : options.threads) {
            const auto figures = measure(world, kinds, founders, threads, options.seconds);
            if (!figures) return fail(figures.error());
            char line[200];
            std::snprintf(line, sizeof line, "%zu,%.1f,%zu,%.2f,%.2f,%.1f,%.1f\n", figures->left,
                          figures->bodies, threads, 1.0 / figures->wall, 1.0 / figures->processor,
                          100.0 * figures->joined, figures->bytes / 1000.0);
            std::fputs(line, stdout);
            csv += line;
        }
    }
    return write_table(options.csv_path, csv);
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) {
    cambrian::bench::Options options;
    CLI::App app("Speed and memory of preserves with more and more creatures.");
    app.add_option("settings", options.settings, "Settings file, e.g. assets/settings/pond.toml")
        ->required();
    app.add_option("files", options.files, "Creature files; otherwise random creatures");
    app.add_option("--creatures", options.creatures, "Numbers of creatures")
        ->check(CLI::Range(1, 1000));
    app.add_option("--threads", options.threads, "Numbers of threads")->check(CLI::Range(1, 64));
    app.add_option("--bodies", options.bodies, "Bodies of a random creature")
        ->check(CLI::Range(2, 16));
    app.add_option("--seconds", options.seconds, "Time of each world, s")
        ->check(CLI::Range(0.1, 10000.0));
    app.add_option("--area", options.area, "Area for each creature, m^2")
        ->check(CLI::Range(1.0, 1000.0));
    app.add_option("--csv", options.csv_path, "File to write the figures to");
    CLI11_PARSE(app, argc, argv);
    return cambrian::bench::run(options);
}
