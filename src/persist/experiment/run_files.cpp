#include "persist/experiment/run_files.h"

#include <system_error>
#include <utility>

namespace cambrian {
namespace {

std::filesystem::path if_there(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::exists(path, unknown) ? path : std::filesystem::path();
}

}  // namespace

void RunFiles::autosave_in(const std::filesystem::path& file) {
    autosave_ = file;
    before_ = if_there(file);
    if (before_.empty()) before_ = if_there(previous_run(file));
}

// Every run gets its own KeptExperiment, so that the writing of the run before can still finish.
void RunFiles::begin(const EvolutionSnapshot& ended) {
    remember(ended);
    chosen_.clear();
    kept_ = std::make_shared<KeptExperiment>(autosave_, kinds_);
}

void RunFiles::open(const EvolutionSnapshot& ended, std::shared_ptr<ExperimentFile> file,
                    const std::filesystem::path& path) {
    const bool was_before = path == before();
    remember(ended);
    if (was_before && path == before_) before_ = if_there(previous_run(autosave_));
    chosen_ = path == autosave_ ? std::filesystem::path() : path;
    kept_ = std::make_shared<KeptExperiment>(std::move(file), kinds_);
}

std::filesystem::path RunFiles::before() const {
    const bool moved_aside = before_ == autosave_ && kept_->took_autosave();
    return moved_aside ? previous_run(autosave_) : before_;
}

// Remembers the file of the present run, which another run is about to replace. A run that kept
// nothing does not count.
void RunFiles::remember(const EvolutionSnapshot& ended) {
    const bool known = std::exchange(ended_, ended.experiment) == ended.experiment;
    if (known || (ended.history.empty() && !kept_->took_autosave())) return;
    before_ = chosen_.empty() ? autosave_ : chosen_;
}

}  // namespace cambrian
