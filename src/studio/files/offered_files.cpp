// What the file panel offers to save, and under which names.

#include "persist/creature/creature_card.h"
#include "pictures/race.h"
#include "studio/experiment/timeline_plots.h"
#include "studio/files/files_controller.h"

#include <fmt/core.h>

#include <cctype>

namespace cambrian {
namespace {

// Turns words into a file name of letters, digits and dashes.
std::string file_stem(const std::string& words) {
    std::string stem;
    for (const char letter : words) {
        const auto byte = static_cast<unsigned char>(letter);
        if (std::isalnum(byte) != 0) {
            stem += static_cast<char>(std::tolower(byte));
        } else if (!stem.empty() && stem.back() != '-') {
            stem += '-';
        }
    }
    while (!stem.empty() && stem.back() == '-')
        stem.pop_back();
    return stem.empty() ? "creature" : stem;
}

bool is_of_run(FileTask task) {
    return task == FileTask::kSaveStatistics || task == FileTask::kSavePlot ||
           task == FileTask::kSaveRunPage || task == FileTask::kSaveFilm;
}

}  // namespace

// Returns whether a task has something to save; if not, shows a notice that says why.
bool FilesController::may_open(FileTask task) {
    const bool of_creature = task == FileTask::kSaveCreature || task == FileTask::kSaveClip;
    if (of_creature && subjects_.viewer.playback().empty()) {
        services_.feedback.tell(NoticeKind::kProblem, "There is no creature on display to save.");
        return false;
    }
    if (is_of_run(task) && subjects_.experiment.open().snapshot().history.empty()) {
        services_.feedback.tell(NoticeKind::kProblem,
                                "There is nothing of a run yet; evolve a generation first.");
        return false;
    }
    const std::size_t stars = subjects_.generations.facts().stars.all().size();
    if (task == FileTask::kSaveRace && (stars < kLeastRunners || stars > kMostRunners)) {
        services_.feedback.tell(NoticeKind::kProblem,
                                fmt::format("A race has {} to {} creatures with a star (K); {} "
                                            "have one.",
                                            kLeastRunners, kMostRunners, stars));
        return false;
    }
    return true;
}

std::string FilesController::suggested_name(FileTask task) const {
    const OpenExperiment& experiment = subjects_.experiment.open();
    switch (task) {
        case FileTask::kOpen:
            return {};
        case FileTask::kSaveCreature:
            return file_stem(subjects_.viewer.playback().exhibit().name()).append(kCreatureEnding);
        case FileTask::kSaveClip:
            return file_stem(subjects_.viewer.playback().exhibit().name()) + ".gif";
        case FileTask::kSaveExperiment:
            return experiment.files().chosen().empty()
                       ? file_stem(experiment.editor().draft().goal) + ".cambrian"
                       : experiment.files().chosen().filename().string();
        case FileTask::kSavePreserve:
            return "pond.cambrian";
        case FileTask::kSaveSettings:
            return "experiment.toml";
        case FileTask::kSaveStatistics:
            return "statistics.csv";
        case FileTask::kSaveRunPage:
            return file_stem(experiment.snapshot().settings->goal) + "-champions.html";
        case FileTask::kSaveFilm:
            return file_stem(experiment.snapshot().settings->goal) + "-film.gif";
        case FileTask::kSaveRace:
            return "race.gif";
        case FileTask::kSavePlot:
            return std::string(timeline_plot(view_.quantity).id) + ".png";
    }
    return {};
}

}  // namespace cambrian
