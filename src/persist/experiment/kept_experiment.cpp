#include "persist/experiment/kept_experiment.h"

#include "core/files/file_lock.h"

#include <fmt/core.h>

#include <system_error>
#include <utility>

namespace cambrian {
namespace {

constexpr int kMostWindows = 20;

// Returns the first of several names that no other window uses.
std::filesystem::path free_name(const std::filesystem::path& wanted) {
    std::filesystem::path path = wanted;
    for (int i = 2; !FileLock::check_free(path) && i < kMostWindows; ++i) {
        path = wanted.parent_path() /
               fmt::format("{}-{}{}", wanted.stem().string(), i, wanted.extension().string());
    }
    return path;
}

// Moves a file together with the files that a killed program left beside it.
void move_aside(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code ignored;
    for (const char* ending : {"-wal", "-shm"})
        std::filesystem::remove(to.string() + ending, ignored);
    std::filesystem::rename(from.string() + "-wal", to.string() + "-wal", ignored);
    std::filesystem::rename(from, to, ignored);
}

}  // namespace

std::filesystem::path previous_run(const std::filesystem::path& autosave) {
    return autosave.parent_path() / "previous.cambrian";
}

Status KeptExperiment::begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders) {
    const std::lock_guard guard(mutex_);
    beginning_ = {settings, founders};
    return {};
}

Status KeptExperiment::note(const NotedCommand& command) {
    const std::lock_guard guard(mutex_);
    if (file_) return file_->note(command);
    notes_.push_back(command);
    return {};
}

Status KeptExperiment::record(const Evolution& evolution) {
    const std::lock_guard guard(mutex_);
    if (!file_) {
        if (Status made = use_autosave(); !made) return made;
    }
    return file_->record(evolution);
}

Status KeptExperiment::crown(const JudgedIndividual& champion) {
    const std::lock_guard guard(mutex_);
    CAMBRIAN_ASSERT(file_ != nullptr, "only a recorded generation has a champion");
    return file_->crown(champion);
}

Status KeptExperiment::use_autosave() {
    Result<std::shared_ptr<ExperimentFile>> file = nameless_file();
    if (!file) return file.error();
    if (!autosave_.empty()) {
        if (Status named = name_autosave(**file); !named) return named;
        took_autosave_ = true;
    }
    take(std::move(*file));
    return {};
}

Status KeptExperiment::name_autosave(ExperimentFile& file) const {
    std::error_code failure;
    std::filesystem::create_directories(autosave_.parent_path(), failure);
    const std::filesystem::path path = free_name(autosave_);
    if (std::filesystem::exists(path, failure)) move_aside(path, free_name(previous_run(path)));
    return file.move_to(path);
}

// Creates a file without a name and writes everything recorded so far.
Result<std::shared_ptr<ExperimentFile>> KeptExperiment::nameless_file() const {
    auto made = ExperimentFile::create(kinds_, beginning_->settings, beginning_->founders);
    if (!made) return made.error();
    for (const NotedCommand& command : notes_) {
        if (Status noted = (*made)->note(command); !noted) return noted.error();
    }
    if (!stars_.empty()) {
        if (Status kept = (*made)->keep_stars(stars_); !kept) return kept.error();
    }
    return made;
}

void KeptExperiment::take(std::shared_ptr<ExperimentFile> file) {
    file_ = std::move(file);
    notes_.clear();
    stars_.clear();
}

Status KeptExperiment::move_to(const std::filesystem::path& path) {
    const std::lock_guard guard(mutex_);
    if (!file_) {
        if (!beginning_) return Error{"there is no experiment yet"};
        Result<std::shared_ptr<ExperimentFile>> file = nameless_file();
        if (!file) return file.error();
        take(std::move(*file));
    }
    return file_->move_to(path);
}

std::filesystem::path KeptExperiment::path() const {
    const std::lock_guard guard(mutex_);
    return file_ ? file_->path() : std::filesystem::path();
}

Status KeptExperiment::keep_picking(const PickingRecord& picking) {
    const std::lock_guard guard(mutex_);
    if (!file_) {
        if (!beginning_) return {};
        if (Status made = use_autosave(); !made) return made;
    }
    return file_->keep_picking(picking);
}

Status KeptExperiment::keep_stars(const std::vector<JudgedIndividual>& stars) {
    const std::lock_guard guard(mutex_);
    if (file_) return file_->keep_stars(stars);
    stars_ = stars;
    return {};
}

}  // namespace cambrian
