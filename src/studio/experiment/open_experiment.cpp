#include "studio/experiment/open_experiment.h"

#include "persist/creature/champion_museum.h"
#include "picking/handover.h"

#include <random>
#include <utility>

namespace cambrian {
namespace {

constexpr double kRateWindow = 0.5;  // s between two readings of the rate
constexpr double kRateInertia = 0.6;
constexpr std::uint64_t kMostDrawnSeed = 999'999;  // short enough to be noted

}  // namespace

ExperimentSettings completed(ExperimentSettings settings, const std::vector<SettingField>& fields) {
    for (const SettingField& field : fields)
        static_cast<void>(field.at(settings));
    return settings;
}

OpenExperiment::OpenExperiment(ExperimentSettings settings, const EvolutionKinds& kinds,
                               std::shared_ptr<EvaluationBackend> backend)
    : kinds_(kinds),
      fields_(setting_fields(kinds)),
      editor_(completed(std::move(settings), fields_)),
      files_(kinds),
      run_seed_(editor_.draft().seed),
      engine_(std::make_shared<const ExperimentSettings>(editor_.draft()), kinds,
              std::move(backend), files_.kept()),
      snapshot_(engine_.latest()) {}

void OpenExperiment::poll() {
    snapshot_ = engine_.latest();
    measure();
}

bool OpenExperiment::fresh() const {
    return snapshot_->generation == 0 && snapshot_->population.empty() && !running() &&
           progress_.done == 0;
}

void OpenExperiment::measure() {
    progress_.done = engine_.progress().done.load(std::memory_order_relaxed);
    progress_.total = engine_.progress().total.load(std::memory_order_relaxed);
    const double elapsed = since_mark_.seconds();
    if (!running() || snapshot_->generation < marked_generation_) {
        progress_.per_second = 0.0;
        progress_.seconds_left = -1.0;
        marked_generation_ = snapshot_->generation;
        marked_done_ = progress_.done;
        since_mark_.restart();
        return;
    }
    if (elapsed < kRateWindow) return;
    // Each generation completed since the last reading counts with the size of the present one.
    const auto generations = static_cast<double>(snapshot_->generation - marked_generation_);
    const double done = generations * progress_.total + static_cast<double>(progress_.done) -
                        static_cast<double>(marked_done_);
    const double rate = done > 0.0 ? done / elapsed : 0.0;
    progress_.per_second = progress_.per_second > 0.0
                               ? kRateInertia * progress_.per_second + (1.0 - kRateInertia) * rate
                               : rate;
    progress_.seconds_left =
        progress_.per_second > 0.0
            ? static_cast<double>(progress_.total - progress_.done) / progress_.per_second
            : -1.0;
    marked_generation_ = snapshot_->generation;
    marked_done_ = progress_.done;
    since_mark_.restart();
}

Status OpenExperiment::commit() {
    editor_.finish();
    if (Status fault = check_settings(editor_.draft(), kinds_); !fault) {
        while (editor_.can_undo() && !check_settings(editor_.draft(), kinds_))
            editor_.refuse();
        return Error{fault.error().message + ". The edit was taken back."};
    }
    if (fresh()) {
        if (editor_.draft() == *snapshot_->settings) return {};
        start({});
        return {};
    }
    const ExperimentSettings next =
        with_live_fields(*snapshot_->settings, editor_.draft(), fields_);
    if (next == *snapshot_->settings) return {};
    if (Status fault = check_settings(next, kinds_); !fault) return fault;
    send(ChangeSettings{std::make_shared<const ExperimentSettings>(next)});
    return {};
}

Status OpenExperiment::start_new_run(std::vector<GenomePtr> founders, RunSeed seed) {
    editor_.finish();
    if (Status fault = check_settings(editor_.draft(), kinds_); !fault) return fault;
    if (seed == RunSeed::kNew && editor_.draft().seed == run_seed_) draw_seed();
    start(std::move(founders));
    ++runs_begun_;
    return {};
}

void OpenExperiment::draw_seed() {
    ExperimentSettings drawn = editor_.draft();
    std::random_device chance;
    while (drawn.seed == editor_.draft().seed)
        drawn.seed = 1 + chance() % kMostDrawnSeed;
    editor_.edit(std::move(drawn), "run.seed");
    editor_.finish();
}

void OpenExperiment::start(std::vector<GenomePtr> founders) {
    files_.begin(*snapshot_);
    run_seed_ = editor_.draft().seed;
    if (founders.empty() && editor_.draft().population.museum > 0.0 && !museum_.empty())
        founders = museum_founders(museum_, editor_.draft(), kinds_);
    begins_at_random_ = founders.empty();
    send(StartExperiment{std::make_shared<const ExperimentSettings>(editor_.draft()),
                         std::move(founders), files_.kept()});
}

void OpenExperiment::autosave_in(const std::filesystem::path& file) {
    files_.autosave_in(file);
    start({});
}

void OpenExperiment::go_on(SavedExperiment saved, std::shared_ptr<ExperimentFile> file,
                           const std::filesystem::path& path) {
    files_.open(*snapshot_, std::move(file), path);
    editor_.replace(completed(*setting_changes(saved).back().settings, fields_));
    run_seed_ = editor_.draft().seed;
    begins_at_random_ = false;
    send(ContinueExperiment{std::make_shared<const SavedExperiment>(std::move(saved)),
                            files_.kept()});
}

Status OpenExperiment::replace(const ExperimentSettings& settings) {
    if (Status fault = check_settings(settings, kinds_); !fault) return fault;
    editor_.replace(completed(settings, fields_));
    return start_new_run({}, RunSeed::kSame);
}

}  // namespace cambrian
