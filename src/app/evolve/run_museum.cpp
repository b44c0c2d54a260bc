#include "app/evolve/run_museum.h"

#include "app/process/messages.h"
#include "app/trial/founder_files.h"
#include "persist/creature/champion_museum.h"

#include <fmt/core.h>

namespace cambrian {

Result<std::vector<GenomePtr>> founders_of(const FounderSources& sources,
                                           const ExperimentSettings& settings,
                                           const EvolutionKinds& kinds) {
    const int places = settings.population.size;
    const auto files = load_founders(sources.files, {"[population] size", places}, settings, kinds);
    if (!files) return files.error();
    std::vector<GenomePtr> founders = genomes_of(*files);
    if (settings.population.museum <= 0.0) return founders;
    if (sources.museum.empty()) return no_museum(settings);
    const std::vector<GenomePtr> drawn = museum_founders(sources.museum, settings, kinds);
    if (drawn.empty()) say(sources.museum + ": the museum has no creature for this world yet");
    for (const GenomePtr& genome : drawn) {
        if (founders.size() < static_cast<std::size_t>(places)) founders.push_back(genome);
    }
    return founders;
}

Status exhibit(const std::string& museum, const CreatureDocument& champion,
               const EvolutionKinds& kinds) {
    if (museum.empty()) return {};
    const auto admitted = admit(museum, champion, kinds);
    if (!admitted) return admitted.error();
    say(fmt::format("{}: {}", museum, words_of(*admitted)));
    return {};
}

}  // namespace cambrian
