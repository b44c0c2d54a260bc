#include "studio/preserve/opened_world.h"

#include "persist/creature/creature_card.h"
#include "persist/creature/creature_file.h"
#include "persist/preserve/preserve_file.h"
#include "persist/settings/settings_file.h"
#include "preserve/life/founders.h"
#include "simulator/simulator_version.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace cambrian {
namespace {

// To walk is the goal that settings have unless they name another one.
bool is_walker(const ExperimentSettings& settings) {
    return settings.world.environment.has_ground && settings.goal == ExperimentSettings().goal;
}

bool is_swimmer(const ExperimentSettings& settings) {
    const Environment& world = settings.world.environment;
    return !world.has_ground && world.gravity == 0.0;
}

// Returns the sample creatures that live so, in the order of their names.
std::vector<GenomePtr> samples_in(const std::filesystem::path& folder, const EvolutionKinds& kinds,
                                  bool (*lives_so)(const ExperimentSettings&)) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    auto entry = std::filesystem::directory_iterator(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        if (entry->path().filename().string().ends_with(kCreatureEnding))
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    std::vector<GenomePtr> samples;
    for (const std::filesystem::path& file : files) {
        const Result<CreatureDocument> document = load_creature(file, kinds);
        if (document && lives_so(document->settings()))
            samples.push_back(document->creature.individual->genome);
    }
    return samples;
}

Result<std::vector<GenomePtr>> founders_of(const WorldPlan& plan,
                                           const ExperimentSettings& settings,
                                           const EvolutionKinds& kinds) {
    if (plan.choice == FounderChoice::kRandom) return random_founders(settings, kinds);
    if (!is_open_choice(plan.choice)) return plan.founders;
    const bool walk = plan.choice == FounderChoice::kWalkers;
    std::vector<GenomePtr> samples = samples_in(plan.samples, kinds, walk ? is_walker : is_swimmer);
    if (!samples.empty()) return samples;
    return Error{fmt::format("There are no {} among the samples in {}.",
                             walk ? "walkers" : "swimmers", plan.samples.string())};
}

}  // namespace

std::filesystem::path preserve_before(const std::filesystem::path& file) {
    return file.parent_path() / (file.stem().string() + "-before.cambrian");
}

Result<OpenedWorld> begin_world(const WorldPlan& plan, const EvolutionKinds& kinds) {
    Result<ExperimentSettings> read = load_settings(plan.settings, kinds, SettingsUse::kPreserve);
    if (!read) return read.error();
    read->seed = plan.seed.value_or(read->seed);
    if (plan.wraps) read->preserve.edges = "wrap";
    if (!plan.ground.is_flat()) read->world.environment.terrain = plan.ground;
    Result<std::vector<GenomePtr>> founders = founders_of(plan, *read, kinds);
    if (!founders) return founders.error();
    read->preserve.founders = std::max(read->preserve.founders, static_cast<int>(founders->size()));
    const auto settings = std::make_shared<const ExperimentSettings>(*std::move(read));
    auto preserve = Preserve::begin(settings, kinds, *founders);
    if (!preserve)
        return Error{fmt::format("The preserve cannot begin: {}.", preserve.error().message)};
    OpenedWorld opened{
        .start = {std::move(*preserve), nullptr, {}}, .file = plan.file, .warnings = {}};
    if (plan.file.empty()) return opened;
    std::error_code missing;
    std::filesystem::create_directories(plan.file.parent_path(), missing);
    std::filesystem::rename(plan.file, preserve_before(plan.file), missing);
    Preserve& world = *opened.start.preserve;
    auto file = PreserveFile::create(
        plan.file, {settings, *std::move(founders), std::string(kSimulatorVersion)},
        world.take_chronicle(), world, kinds);
    if (!file) return file.error();
    opened.start.log = *std::move(file);
    return opened;
}

Result<OpenedWorld> open_world(const std::filesystem::path& path, const EvolutionKinds& kinds) {
    Result<PreserveFile::Opened> opened = PreserveFile::open(path, kinds);
    if (!opened) return opened.error();
    auto preserve = Preserve::resume(opened->origin.settings, kinds, opened->origin.founders,
                                     opened->state, opened->laws);
    if (!preserve)
        return Error{fmt::format("cannot open {}: {}", path.string(), preserve.error().message)};
    OpenedWorld world{.start = {std::move(*preserve), std::move(opened->file),
                                std::move(opened->series), std::move(opened->museum)},
                      .file = path,
                      .warnings = std::move(opened->warnings),
                      .pins = std::move(opened->pins)};
    if (opened->origin.simulator != kSimulatorVersion) {
        world.warnings.push_back(
            fmt::format("It was begun by simulator {}, this is {}; from here on it is another "
                        "motion than there.",
                        opened->origin.simulator, kSimulatorVersion));
    }
    return world;
}

Result<OpenedWorld> branch_world(const std::filesystem::path& from,
                                 std::optional<std::uint64_t> tick, const std::filesystem::path& to,
                                 const EvolutionKinds& kinds) {
    Status copied;
    if (!tick) {
        const Result<SavedPreserve> saved = load_preserve(from, kinds);
        if (saved) {
            tick = saved->snapshots.back().tick;
        } else {
            copied = saved.error();
        }
    }
    if (copied) copied = copy_preserve(from, *tick, to, kinds);
    if (copied) return open_world(to, kinds);
    Result<OpenedWorld> original = open_world(from, kinds);
    if (original) original->warnings.push_back(copied.error().message);
    return original;
}

}  // namespace cambrian
