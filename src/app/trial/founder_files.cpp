#include "app/trial/founder_files.h"

#include "app/process/messages.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {

Result<std::vector<CreatureDocument>> load_founders(std::span<const std::string> files,
                                                    const FounderPlaces& places,
                                                    const ExperimentSettings& settings,
                                                    const EvolutionKinds& kinds) {
    if (files.size() > static_cast<std::size_t>(places.count)) {
        return Error{fmt::format("{}: {} creatures, but {} is {}", places.option, files.size(),
                                 places.setting, places.count)};
    }
    std::vector<CreatureDocument> founders;
    for (const std::string& file : files) {
        Result<CreatureDocument> document = load_creature(file, kinds);
        if (!document) return document.error();
        say_of(file, document->warnings);
        say_of(file, foreign_kinds(document->genome(), settings.founders, kinds));
        founders.push_back(*std::move(document));
    }
    return founders;
}

std::vector<GenomePtr> genomes_of(std::span<const CreatureDocument> founders) {
    std::vector<GenomePtr> genomes;
    for (const CreatureDocument& founder : founders)
        genomes.push_back(founder.creature.individual->genome);
    return genomes;
}

std::string no_settings_file(const std::vector<std::string>& founders) {
    std::string missing = "a settings file to begin with, or --resume FILE, is required";
    for (const std::string& founder : founders) {
        if (founder.ends_with(".toml"))
            return fmt::format("{}; {} is behind --founders, and must come before it", missing,
                               founder);
    }
    return missing;
}

}  // namespace cambrian
