#pragma once

// Reads and writes files in the background, so that the window does not wait. Results arrive as
// events.

#include "core/image.h"
#include "evolution/individual/statistics.h"
#include "persist/creature/creature_file.h"
#include "persist/experiment/kept_experiment.h"
#include "pictures/motion/subject.h"
#include "studio/background/background_worker.h"
#include "studio/files/file_browser.h"
#include "studio/preserve/opened_world.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
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
struct PreserveSettingsLoaded {
    std::filesystem::path path;
    ExperimentSettings settings;
};
struct ExperimentLoaded {
    std::filesystem::path path;
    std::shared_ptr<OpenedExperiment> experiment;
};
struct PreserveLoaded {
    std::filesystem::path path;
    std::shared_ptr<OpenedWorld> world;
};
// A file of a world with other dimensions than that of the studio.
struct FileElsewhere {
    std::filesystem::path path;
};
struct FileSaved {
    std::filesystem::path path;
};
// A creature card whose picture is not drawn yet.
struct PreparedCard {
    std::filesystem::path path;
    std::string text;  // the creature file that the card embeds
    Subject subject;
};
struct CardPrepared {
    PreparedCard card;
};
struct FolderListed {
    FolderListing listing;
};
struct FileFailed {
    std::filesystem::path path;
    std::string message;
    bool reading = false;  // rather than writing
};
using FileEvent =
    std::variant<CreatureLoaded, SettingsLoaded, PreserveSettingsLoaded, ExperimentLoaded,
                 PreserveLoaded, FileElsewhere, FileSaved, CardPrepared, FolderListed, FileFailed>;

struct CardOrder {
    std::filesystem::path path;
    CreatureDocument document;
    std::string title;                 // title for a creature without a name
    ExperimentSettings settings = {};  // settings of the trial shown on the card
    std::optional<std::uint32_t> generation = {};
};

class FileService {
public:
    // All must outlive the object; see load_file().
    FileService(BackgroundWorker& worker, const EvolutionKinds& kinds,
                const EvolutionKinds* elsewhere)
        : worker_(worker), kinds_(kinds), elsewhere_(elsewhere) {}

    // Loads a creature, card, settings, experiment or preserve file; its name or content tells
    // which.
    void load(const std::filesystem::path& path);
    void save_creature(const std::filesystem::path& path, CreatureDocument document);
    // A card is saved in two steps: prepare_card(), then save_card() with the picture that the
    // window drew.
    void prepare_card(CardOrder order);
    void save_card(const std::filesystem::path& path, Image picture, std::string document);
    void save_experiment(const std::filesystem::path& path,
                         std::shared_ptr<KeptExperiment> experiment);
    void save_settings(const std::filesystem::path& path, const ExperimentSettings& settings);
    void save_statistics(const std::filesystem::path& path,
                         std::vector<GenerationStatistics> history);
    void save_picture(const std::filesystem::path& path, Image image);
    void list(const std::filesystem::path& folder, FileTask task);

    std::vector<FileEvent> take_events();

private:
    // Runs `work` on the worker's thread and delivers its event here.
    template <class Work>
    void run(Work work);

    BackgroundWorker& worker_;
    const EvolutionKinds& kinds_;
    const EvolutionKinds* elsewhere_;
    std::vector<FileEvent> events_;
};

// Returns whether a creature saved under this name becomes a card.
bool is_card_name(const std::filesystem::path& path);
// Returns whether it becomes a page.
bool is_page_path(const std::filesystem::path& path);

// Loads a file and returns its event. The call blocks. A file that is not of the world of `kinds`
// but can be read with those elsewhere, if there are any, is FileElsewhere.
FileEvent load_file(const std::filesystem::path& path, const EvolutionKinds& kinds,
                    const EvolutionKinds* elsewhere = nullptr);

}  // namespace cambrian
