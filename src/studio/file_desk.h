#pragma once

// Reading and writing files without the window waiting: tasks go to the background worker, what
// came of them is collected as events.

#include "evolution/statistics.h"
#include "persist/creature_file.h"
#include "persist/kept_experiment.h"
#include "render/image.h"
#include "studio/background_worker.h"
#include "studio/file_browser.h"

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace cambrian {

struct CreatureLoaded {
    std::filesystem::path path;
    CreatureDocument document;
};
struct SettingsLoaded {
    std::filesystem::path path;
    ExperimentSettings settings;
};
struct ExperimentLoaded {
    std::filesystem::path path;
    std::shared_ptr<OpenedExperiment> experiment;
};
struct FileSaved {
    std::filesystem::path path;
};
struct FolderListed {
    FolderListing listing;
};
struct FileFailed {
    std::filesystem::path path;
    std::string message;
};
using FileEvent = std::variant<CreatureLoaded, SettingsLoaded, ExperimentLoaded, FileSaved,
                               FolderListed, FileFailed>;

class FileDesk {
public:
    // Both must outlive it.
    FileDesk(BackgroundWorker& worker, const EvolutionKinds& kinds)
        : worker_(worker), kinds_(kinds) {}

    // By the name's ending: a creature, settings or an experiment.
    void load(const std::filesystem::path& path);
    void save_creature(const std::filesystem::path& path, CreatureDocument document);
    void save_experiment(const std::filesystem::path& path,
                         std::shared_ptr<KeptExperiment> experiment);
    void save_settings(const std::filesystem::path& path, const ExperimentSettings& settings);
    void save_statistics(const std::filesystem::path& path,
                         std::vector<GenerationStatistics> history);
    void save_picture(const std::filesystem::path& path, Image image);
    void list(const std::filesystem::path& folder, FileTask task);

    std::vector<FileEvent> take_events();

private:
    // Runs on the worker, its event comes back here.
    template <class Work>
    void run(Work work);

    BackgroundWorker& worker_;
    const EvolutionKinds& kinds_;
    std::vector<FileEvent> events_;
};

// What loading a path gives; blocks.
FileEvent load_file(const std::filesystem::path& path, const EvolutionKinds& kinds);

}  // namespace cambrian
