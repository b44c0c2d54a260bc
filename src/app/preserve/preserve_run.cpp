#include "app/preserve/preserve_run.h"

#include "app/command_line/started_file.h"
#include "app/preserve/preserve_report.h"
#include "app/process/interruption.h"
#include "app/process/messages.h"
#include "app/process/progress_line.h"
#include "app/trial/founder_files.h"
#include "app/trial/score_notice.h"
#include "core/stopwatch.h"
#include "core/text/shell_word.h"
#include "persist/preserve/preserve_file.h"
#include "persist/settings/settings_file.h"
#include "preserve/laws.h"
#include "preserve/life/founders.h"
#include "simulator/simulator_version.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

namespace cambrian {
namespace {

constexpr std::uint64_t kTicksPerReport = 3600;  // 60 s, between two lines for people

Result<SettingsPtr> preserve_settings_of(const PreserveRun& run, const EvolutionKinds& kinds) {
    Result<ExperimentSettings> settings =
        load_settings(run.settings_file, kinds, SettingsUse::kPreserve);
    if (!settings) return settings.error();
    settings->seed = run.seed.value_or(settings->seed);
    return std::make_shared<const ExperimentSettings>(*std::move(settings));
}

Result<std::vector<GenomePtr>> preserve_founders_of(const PreserveRun& run,
                                                    const ExperimentSettings& settings,
                                                    const EvolutionKinds& kinds) {
    if (run.founders.empty()) return random_founders(settings, kinds);
    const auto founders = load_founders(
        run.founders, {"[preserve] founders", settings.preserve.founders}, settings, kinds);
    if (!founders) return founders.error();
    for (std::size_t i = 0; i < founders->size(); ++i)
        say_of_simulator(run.founders[i], (*founders)[i]);
    return genomes_of(*founders);
}

// A preserve and the file that keeps it, if any.
struct World {
    std::unique_ptr<Preserve> preserve = nullptr;
    StartedFile made = {};  // of this start; it is removed after `file` is closed
    std::unique_ptr<PreserveFile> file = nullptr;
    std::string name = {};  // of the file
};

Result<World> new_world(const PreserveRun& run, const EvolutionKinds& kinds) {
    const Result<SettingsPtr> settings = preserve_settings_of(run, kinds);
    if (!settings) return settings.error();
    Result<std::vector<GenomePtr>> founders = preserve_founders_of(run, **settings, kinds);
    if (!founders) return founders.error();
    World world;
    auto begun = Preserve::begin(*settings, kinds, *founders);
    if (!begun) {
        const char* where = run.founders.empty() ? run.settings_file.c_str() : "--founders";
        return Error{fmt::format("{}: {}", where, begun.error().message)};
    }
    world.preserve = std::move(*begun);
    if (run.out.empty()) return world;
    auto file = PreserveFile::create(
        run.out, {*settings, *std::move(founders), std::string(kSimulatorVersion)},
        world.preserve->take_chronicle(), *world.preserve, kinds);
    if (!file) return file.error();
    world.made = StartedFile(run.out);
    world.file = std::move(*file);
    world.name = run.out;
    return world;
}

Result<World> resumed_world(const PreserveRun& run, const EvolutionKinds& kinds) {
    Result<PreserveFile::Opened> opened = PreserveFile::open(run.resume, kinds);
    if (!opened) return opened.error();
    say_of(run.resume, opened->warnings);
    if (opened->origin.simulator != kSimulatorVersion) {
        say(
            fmt::format("{}: it was begun by simulator {}, this is {}; from here on it is another "
                        "motion than there",
                        run.resume, opened->origin.simulator, kSimulatorVersion));
    }
    auto preserve = Preserve::resume(opened->origin.settings, kinds, opened->origin.founders,
                                     opened->state, opened->laws);
    if (!preserve)
        return Error{fmt::format("cannot open {}: {}", run.resume, preserve.error().message)};
    return World{std::move(*preserve), {}, std::move(opened->file), run.resume};
}

// Rests after the changes, so that the next snapshot that is written has them.
Status change_laws(Preserve& preserve, const std::vector<std::string>& laws) {
    if (laws.empty()) return {};
    for (const std::string& law : laws) {
        const Result<Intervention> change = law_change_of(law);
        const Result<std::uint64_t> changed =
            change ? preserve.intervene(*change) : Result<std::uint64_t>(change.error());
        if (!changed) return Error{fmt::format("--law {}: {}", law, changed.error().message)};
    }
    const Result<std::uint64_t> rested = preserve.intervene({.what = intervention::kRest});
    return rested ? Status() : rested.error();
}

// Tells how the preserve is doing: a line on the terminal all the time, and lines of output.
class PreserveReport {
public:
    explicit PreserveReport(bool json) : json_(json), line_([this] { return status(); }) {}

    // Prints what a chronicle has; `begun` is the tick at which the computation began.
    Status tell(const Preserve& preserve, const std::vector<SeriesRow>& rows, std::uint64_t begun) {
        const double factor = factor_of(preserve, begun);
        Status told;
        for (const SeriesRow& row : rows) {
            const std::string words = preserve_words(row, factor);
            {
                const std::lock_guard lock(mutex_);
                status_ = words;
            }
            if (!json_ && row.tick % kTicksPerReport != 0) continue;
            line_.interrupt([&] {
                told = print_line(
                    json_ ? preserve_json(row, factor, digest_of(words_of(preserve.save())))
                          : words);
            });
            if (!told) return told;
        }
        return told;
    }

    // Prints the state at the end for people, unless it was the last that was printed.
    Status tell_end(const Preserve& preserve, std::uint64_t begun) {
        Status told;
        if (json_ || preserve.ticks() % kTicksPerReport == 0) return told;
        line_.interrupt(
            [&] { told = print_line(preserve_words(preserve.row(), factor_of(preserve, begun))); });
        return told;
    }

private:
    double factor_of(const Preserve& preserve, std::uint64_t begun) const {
        const double seconds = line_.seconds();
        return seconds > 0.0 ? static_cast<double>(preserve.ticks() - begun) / 60.0 / seconds : 0.0;
    }
    std::string status() const {
        const std::lock_guard lock(mutex_);
        return status_;
    }

    const bool json_;
    mutable std::mutex mutex_;
    std::string status_;  // guarded by mutex_
    ProgressLine line_;   // last member, since it reads the others
};

std::uint64_t last_tick(const PreserveRun& run) {
    if (!run.seconds) return std::numeric_limits<std::uint64_t>::max();
    return static_cast<std::uint64_t>(std::llround(*run.seconds * 60.0));
}

// Writes to the file, if there is one, at each snapshot, and at the end.
Status keep(World& world, Chronicle& pending, bool at_end) {
    const bool due = at_end || world.preserve->ticks() % kTicksPerSnapshot == 0;
    if (!due) return {};
    const Chronicle chronicle = std::exchange(pending, {});
    return world.file ? world.file->write(chronicle, *world.preserve) : Status();
}

// Computes until the end is reached, an interruption is requested, or writing fails.
Status compute(World& world, const PreserveRun& run, const Interruption& interruption) {
    ThreadPool pool(run.threads ? static_cast<std::size_t>(*run.threads)
                                : ThreadPool::default_workers());
    PreserveReport report(run.json);
    world.made.keep();  // all threads have started
    Preserve& preserve = *world.preserve;
    const std::uint64_t begun = preserve.ticks();
    const std::uint64_t end = last_tick(run);
    Chronicle pending = preserve.take_chronicle();
    // A snapshot of now, since the next one may never come, and changed laws would be lost.
    if (!run.laws.empty()) {
        if (Status kept = keep(world, pending, true); !kept) return kept;
    }
    while (preserve.ticks() < end && !interruption.requested()) {
        preserve.tick(pool);
        Chronicle chronicle = preserve.take_chronicle();
        if (Status told = report.tell(preserve, chronicle.series, begun); !told) return told;
        append(pending, std::move(chronicle));
        if (Status kept = keep(world, pending, false); !kept) return kept;
    }
    if (Status told = report.tell_end(preserve, begun); !told) return told;
    return keep(world, pending, true);
}

// Says so if solid bodies were often too crowded to be moved exactly.
void warn_of_crowds(const Preserve& preserve) {
    constexpr double kMostCrowded = 0.01;
    const SolidCounts counts = preserve.solid_counts();
    const double share = static_cast<double>(counts.crowded_ticks) /
                         static_cast<double>(std::max<std::uint64_t>(counts.ticks, 1));
    if (share <= kMostCrowded) return;
    say(
        fmt::format("crowded: in {:.0f} % of their time, creatures touched more others than can be "
                    "moved together, and were pressed apart by springs",
                    100.0 * share));
}

}  // namespace

CommandFiles files_of(const PreserveRun& run) {
    CommandFiles files;
    files.reads(run.settings_file).reads(run.resume);
    for (const std::string& founder : run.founders)
        files.reads(founder);
    return files.keeps(run.out);
}

ExitStatus run_preserve(const PreserveRun& run, const EvolutionKinds& kinds) {
    if (run.resume.empty() && run.settings_file.empty())
        return fail({no_settings_file(run.founders)});
    if (!run.out.empty() && !is_experiment_name(run.out))
        return fail({fmt::format("--out {}: expected a file named *.cambrian", run.out)});
    Result<World> world = run.resume.empty() ? new_world(run, kinds) : resumed_world(run, kinds);
    if (!world) return fail(world.error());
    if (world->preserve->ticks() >= last_tick(run) && !run.resume.empty()) {
        return fail({fmt::format("{}: has reached {} s; --seconds T asks for more", run.resume,
                                 world->preserve->ticks() / 60)});
    }
    if (Status changed = change_laws(*world->preserve, run.laws); !changed)
        return fail(changed.error());
    if (!world->file && !run.json) say("this preserve is not kept; --out FILE.cambrian keeps one");
    const Interruption interruption;
    if (Status computed = compute(*world, run, interruption); !computed)
        return fail(computed.error(), ExitStatus::kFailed);
    warn_of_crowds(*world->preserve);
    const bool within_minute = world->preserve->ticks() % kTicksPerSnapshot != 0;
    if (world->file && (interruption.requested() || within_minute)) {
        say(fmt::format("{}`cambrian preserve --resume {}` goes on from the last full minute",
                        interruption.requested() ? "stopped; " : "", shell_word(world->name)));
    }
    return ExitStatus::kDone;
}

}  // namespace cambrian
