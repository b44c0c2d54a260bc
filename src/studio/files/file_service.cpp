#include "studio/files/file_service.h"

#include "core/files/file_io.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/page_document.h"
#include "persist/creature/png_file.h"
#include "persist/experiment/file_dimensions.h"
#include "persist/preserve/preserve_file.h"
#include "persist/records/statistics_csv.h"
#include "persist/settings/settings_file.h"

#include <utility>

namespace cambrian {
namespace {

FileEvent saved(const std::filesystem::path& path, const Status& status) {
    if (status) return FileSaved{path};
    return FileFailed{path, status.error().message};
}

FileEvent prepared(CardOrder order, const EvolutionKinds& kinds, const std::stop_token& stop) {
    complete_score(order.document, kinds, stop);
    auto subject = subject_of(order.document, order.settings, order.title, kinds);
    if (!subject) return FileFailed{order.path, subject.error().message};
    subject->generation = order.generation;
    return CardPrepared{{order.path, write_creature(order.document, kinds), std::move(*subject)}};
}

FileEvent loaded_settings(const std::filesystem::path& path, const EvolutionKinds& kinds) {
    const Result<SettingsText> text = read_settings_text(path);
    if (!text) return FileFailed{path, text.error().message, true};
    const SettingsUse use = use_of_settings(text->text);
    Result<ExperimentSettings> settings = parse_settings(text->text, text->source, kinds, use);
    if (!settings) return FileFailed{path, settings.error().message, true};
    if (use == SettingsUse::kPreserve) return PreserveSettingsLoaded{path, *std::move(settings)};
    return SettingsLoaded{path, *std::move(settings)};
}

FileEvent load_with(const EvolutionKinds& kinds, const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    if (name.ends_with(".toml")) {
        return loaded_settings(path, kinds);
    }
    if (name.ends_with(".json") || name.ends_with(".apng") || name.ends_with(kPageEnding) ||
        cambrian::is_card_name(path)) {
        auto document = load_creature(path, kinds);
        if (document) return CreatureLoaded{path, std::move(*document)};
        return FileFailed{path, document.error().message, true};
    }
    if (name.ends_with(".cambrian") && is_preserve_file(path)) {
        auto world = open_world(path, kinds);
        if (world) return PreserveLoaded{path, std::make_shared<OpenedWorld>(*std::move(world))};
        return FileFailed{path, world.error().message, true};
    }
    if (name.ends_with(".cambrian")) {
        auto experiment = open_experiment(path, kinds);
        if (experiment)
            return ExperimentLoaded{path,
                                    std::make_shared<OpenedExperiment>(*std::move(experiment))};
        return FileFailed{path, experiment.error().message, true};
    }
    return FileFailed{path,
                      path.string() +
                          " is not a file the studio opens; expected *.creature.json, a card "
                          "*.png, a page *.html, an experiment or a preserve *.cambrian, or "
                          "settings *.toml",
                      true};
}

}  // namespace

bool is_card_name(const std::filesystem::path& path) {
    return path.extension() == ".png";
}

bool is_page_path(const std::filesystem::path& path) {
    return path.extension() == kPageEnding;
}

FileEvent load_file(const std::filesystem::path& path, const EvolutionKinds& kinds,
                    const EvolutionKinds* elsewhere) {
    const bool abroad =
        elsewhere != nullptr && dimensions_of_file(path) != kinds.creature.scene.dimensions;
    FileEvent event = load_with(abroad ? *elsewhere : kinds, path);
    // A file that cannot be read is no reason to leave this world.
    if (abroad && !std::holds_alternative<FileFailed>(event)) return FileElsewhere{path};
    return event;
}

template <class Work>
void FileService::run(Work work) {
    worker_.submit([this, work = std::move(work)](const std::stop_token& stop) mutable {
        auto event = std::make_shared<FileEvent>(work(stop));
        return [this, event] { events_.push_back(std::move(*event)); };
    });
}

void FileService::load(const std::filesystem::path& path) {
    run([path, &kinds = kinds_, elsewhere = elsewhere_](const std::stop_token&) {
        return load_file(path, kinds, elsewhere);
    });
}

void FileService::save_creature(const std::filesystem::path& path, CreatureDocument document) {
    run([path, document = std::move(document),
         &kinds = kinds_](const std::stop_token& stop) mutable {
        complete_score(document, kinds, stop);
        return saved(path, cambrian::save_creature(path, document, kinds));
    });
}

void FileService::prepare_card(CardOrder order) {
    run([order = std::move(order), &kinds = kinds_](const std::stop_token& stop) mutable {
        return prepared(std::move(order), kinds, stop);
    });
}

void FileService::save_card(const std::filesystem::path& path, Image picture,
                            std::string document) {
    run([path, picture = std::move(picture),
         document = std::move(document)](const std::stop_token&) {
        return saved(path, cambrian::save_card(path, picture, document));
    });
}

void FileService::save_experiment(const std::filesystem::path& path,
                                  std::shared_ptr<KeptExperiment> experiment) {
    run([path, experiment = std::move(experiment)](const std::stop_token&) {
        return saved(path, experiment->move_to(path));
    });
}

void FileService::save_settings(const std::filesystem::path& path,
                                const ExperimentSettings& settings) {
    run([path, settings, &kinds = kinds_](const std::stop_token&) {
        return saved(path, cambrian::save_settings(path, settings, kinds));
    });
}

void FileService::save_statistics(const std::filesystem::path& path,
                                  std::vector<GenerationStatistics> history) {
    run([path, history = std::move(history)](const std::stop_token&) {
        return saved(path, write_file(path, statistics_csv(history)));
    });
}

void FileService::save_picture(const std::filesystem::path& path, Image image) {
    run([path, image = std::move(image)](const std::stop_token&) {
        const Result<std::string> png = encode_png(image);
        return saved(path, png ? write_file(path, *png) : Status(png.error()));
    });
}

void FileService::list(const std::filesystem::path& folder, FileTask task) {
    run([folder, task](const std::stop_token&) {
        return FileEvent(FolderListed{list_folder(folder, task)});
    });
}

std::vector<FileEvent> FileService::take_events() {
    return std::exchange(events_, {});
}

}  // namespace cambrian
