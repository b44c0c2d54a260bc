// cambrian_bench_senses: runs the trials of creatures with and without their senses, in the same
// motion, so that the difference of the instructions is the cost of the senses.
// count_senses.sh counts them.

#include "app/builtin_kinds.h"
#include "bench/sense_variants.h"
#include "genome/founders/random_genome.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "simulator/trial.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace cambrian::bench {
namespace {

struct Options {
    std::string settings;
    std::vector<std::string> files;
    std::size_t founders = 0;
    double seconds = 15.0;
    std::string senses = "all";
    bool every_channel = false;
    bool light = false;
};

// Motor targets of a trial, tick after tick, and the next one to play.
struct Tape {
    std::vector<double> targets;
    std::size_t next = 0;
};
Tape tape;

void play(const EffectorSite& site, double /*signal*/, double /*share*/,
          const SceneSettings& /*settings*/, double& /*memory*/, PhysicsScene& scene) {
    scene.set_target(site.index, tape.targets[tape.next++]);
}

// Returns kinds whose effectors play the tape, whatever the brain says.
Kinds playing_kinds(Kinds kinds) {
    EffectorRegistry effectors;
    for (const EffectorKind& kind : kinds.effectors.all())
        effectors.add({.id = kind.id, .label = kind.label, .drive = play});
    kinds.effectors = std::move(effectors);
    return kinds;
}

void record(const std::shared_ptr<const Phenotype>& phenotype, const Kinds& kinds,
            const TrialWorld& world) {
    tape = {};
    auto trial = Trial::start(phenotype, kinds, world);
    for (bool more = bool(trial); more;) {
        const bool settling = (*trial)->settling();
        more = (*trial)->tick();
        if (settling) continue;
        for (const std::uint16_t part : phenotype->effector_parts)
            tape.targets.push_back((*trial)->scene().target(part));
    }
}

[[gnu::noinline]] void count_trial(Trial& trial) {
    while (trial.tick()) {
    }
}

struct Totals {
    std::size_t creatures = 0;
    std::size_t parts = 0;
    std::size_t sensors = 0;
    std::uint64_t ticks = 0;
    Hash64 motion;
};

void add_creature(const Genome& genome, const ExperimentSettings& settings, const Kinds& kinds,
                  const Options& options, Totals& totals) {
    const auto walker = std::make_shared<const Phenotype>(
        express(genome, kinds, settings.expression, settings.world.scene));
    if (!walker->can_move() || !walker->has_live_control) return;
    static const Kinds players = playing_kinds(kinds);
    record(walker, kinds, settings.world);
    const Phenotype senser =
        options.every_channel ? with_every_channel(*walker, kinds) : Phenotype(*walker);
    const auto subject =
        std::make_shared<const Phenotype>(with_senses(senser, kinds, options.senses));
    auto trial = Trial::start(subject, players, settings.world);
    if (!trial) return;
    count_trial(**trial);
    ++totals.creatures;
    totals.parts += subject->parts.size();
    totals.sensors += subject->sensors.size();
    totals.ticks += (*trial)->ticks();
    totals.motion.add((*trial)->record().digest);
}

int run(const Options& options) {
    const EvolutionKinds kinds = builtin_kinds();
    Result<ExperimentSettings> settings = load_settings(options.settings, kinds);
    if (!settings) {
        std::fprintf(stderr, "%s\n", settings.error().message.c_str());
        return 2;
    }
    settings->world.trial.duration = options.seconds;
    settings->world.trial.stop_at_rest = false;
    if (options.light) settings->world.environment.has_light = true;
    for (const ChannelEntry& channel : kinds.creature.catalog.channels)
        settings->founders.channels[channel.id] = true;
    Totals totals;
    for (const std::string& file : options.files) {
        const Result<CreatureDocument> document = load_creature(file, kinds);
        if (!document) {
            std::fprintf(stderr, "%s\n", document.error().message.c_str());
            return 2;
        }
        add_creature(document->genome(), *settings, kinds.creature, options, totals);
    }
    RandomStream stream(stream_seed({1994, 22}));
    for (std::size_t i = 0; i < options.founders; ++i)
        add_creature(random_genome(settings->founders, kinds.creature.catalog, stream), *settings,
                     kinds.creature, options, totals);
    std::printf("%zu,%zu,%zu,%llu,%016llx\n", totals.creatures, totals.parts, totals.sensors,
                static_cast<unsigned long long>(totals.ticks),
                static_cast<unsigned long long>(totals.motion.value()));
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace cambrian::bench

int main(int argc, char** argv) {
    cambrian::bench::Options options;
    CLI::App app("Trials of creatures with and without their senses, in the same motion.");
    app.add_option("settings", options.settings, "Settings file, e.g. assets/settings/walking.toml")
        ->required();
    app.add_option("files", options.files, "Creature files");
    app.add_option("--founders", options.founders, "Random creatures with every sense");
    app.add_option("--seconds", options.seconds, "Length of a trial, s")
        ->check(CLI::Range(0.1, 100.0));
    app.add_option("--senses", options.senses, "Sensors that are read")
        ->check(CLI::IsMember({"all", "1994", "none"}));
    app.add_flag("--every-channel", options.every_channel,
                 "Gives each creature one more sensor of every channel");
    app.add_flag("--light", options.light, "Switches the light on");
    CLI11_PARSE(app, argc, argv);
    return cambrian::bench::run(options);
}
