#include "comparison/comparison.h"

#include "comparison/run_table.h"
#include "core/files/file_io.h"
#include "core/threads/thread_pool.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/creature_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

namespace cambrian {
namespace {

constexpr const char* kTable = "runs.csv";
constexpr const char* kChampions = "champions";

const ComparedRun* row_of(const std::vector<ComparedRun>& table, const PlannedRun& run,
                          const EvolutionKinds& kinds) {
    const ComparedRun planned = planned_row(run, kinds);
    const auto found = std::find_if(table.begin(), table.end(), [&](const ComparedRun& row) {
        return is_row_of(row, planned);
    });
    return found == table.end() ? nullptr : &*found;
}

// Makes a name that is valid on every file system.
std::string file_name(std::string name) {
    for (char& letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        if (code <= ' ' || letter == '/' || code == 0x7F) letter = '-';
    }
    return name.append(kCreatureEnding);
}

// The name that earlier versions gave to all runs of a world and an arm with the same seed.
std::string short_name(const ComparedRun& run) {
    return fmt::format("{}-{}-seed{}", run.world, run.arm, run.seed);
}

std::string full_name(const ComparedRun& run) {
    return fmt::format("{}-{}-{}", short_name(run), run.trials, run.settings.substr(0, 8));
}

}  // namespace

std::filesystem::path champion_file(const std::filesystem::path& folder, const ComparedRun& run) {
    const auto file = folder / kChampions / file_name(full_name(run));
    const auto earlier = folder / kChampions / file_name(short_name(run));
    std::error_code unknown;
    const bool use_earlier =
        !std::filesystem::exists(file, unknown) && std::filesystem::exists(earlier, unknown);
    return use_earlier ? earlier : file;
}

Result<std::unique_ptr<Comparison>> Comparison::open(const std::filesystem::path& folder,
                                                     std::vector<PlannedRun> runs,
                                                     const EvolutionKinds& kinds) {
    std::error_code failure;
    std::filesystem::create_directories(folder / kChampions, failure);
    if (failure)
        return Error{fmt::format("{}: {}", (folder / kChampions).string(), failure.message())};
    if (const Status writable = check_writable(folder / kTable); !writable) return writable.error();
    auto table = load_run_table(folder / kTable);
    if (!table) return table.error();
    return std::unique_ptr<Comparison>(
        new Comparison(folder, std::move(runs), *std::move(table), kinds));
}

Comparison::Comparison(std::filesystem::path folder, std::vector<PlannedRun> runs,
                       std::vector<ComparedRun> table, const EvolutionKinds& kinds)
    : folder_(std::move(folder)), runs_(std::move(runs)), table_(std::move(table)), kinds_(&kinds) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        if (row_of(table_, runs_[i], kinds) != nullptr) continue;
        missing_.push_back(i);
        planned_ += static_cast<std::uint64_t>(runs_[i].trials);
    }
}

Result<std::optional<FinishedRun>> Comparison::perform_missing(
    std::size_t index, std::unique_ptr<EvaluationBackend>& backend, const BackendMaking& make,
    const std::stop_token& stop) {
    if (!backend) {
        auto made = make();
        if (!made) return made.error();
        backend = *std::move(made);
    }
    auto finished = perform(runs_[missing_[index]], *kinds_, *backend, done_, stop);
    if (!finished && !stop.stop_requested()) return Error{backend->status().failure};
    return finished;
}

Status Comparison::run(std::size_t at_a_time, const BackendMaking& make,
                       const std::function<void(const ComparedRun&)>& told,
                       const std::stop_token& stop) {
    std::mutex mutex;
    Status kept;  // guarded by the mutex
    std::stop_source failed;
    const std::stop_callback pass_on(stop, [&failed] { failed.request_stop(); });
    ThreadPool pool(at_a_time);
    std::vector<std::unique_ptr<EvaluationBackend>> backends(at_a_time);  // one per thread
    pool.parallel_for(
        missing_.size(),
        [&](std::size_t index, std::size_t thread) {
            const auto finished =
                perform_missing(index, backends[thread], make, failed.get_token());
            if (finished && !*finished) return;
            const std::lock_guard<std::mutex> lock(mutex);
            if (!kept) return;
            kept = finished ? keep(**finished) : finished.error();
            if (!kept) {
                failed.request_stop();
                return;
            }
            told((*finished)->row);
        },
        failed.get_token());
    return kept;
}

double Comparison::share_done() const {
    if (planned_ == 0) return 1.0;
    return std::min(1.0, static_cast<double>(done_) / static_cast<double>(planned_));
}

std::vector<ComparedRun> Comparison::finished() const {
    std::vector<ComparedRun> rows;
    for (const PlannedRun& run : runs_) {
        if (const ComparedRun* row = row_of(table_, run, *kinds_)) rows.push_back(*row);
    }
    return rows;
}

// Saves the champion before the row, so that every run in the table has one. The order of rows does
// not depend on which run ends first.
Status Comparison::keep(const FinishedRun& finished) {
    CreatureDocument champion = creature_document(
        {.individual = finished.champion, .settings = finished.settings}, *kinds_);
    complete_score(champion, *kinds_);
    const auto file = folder_ / kChampions / file_name(full_name(finished.row));
    if (Status saved = save_creature(file, champion, *kinds_); !saved) return saved;
    table_.push_back(finished.row);
    std::sort(table_.begin(), table_.end(), [](const ComparedRun& a, const ComparedRun& b) {
        return std::tie(a.world, a.arm, a.seed, a.trials, a.settings, a.simulator) <
               std::tie(b.world, b.arm, b.seed, b.trials, b.settings, b.simulator);
    });
    return write_file(folder_ / kTable, run_table_csv(table_));
}

}  // namespace cambrian
