#include "studio/files/sample_library.h"

#include "core/text/code_points.h"
#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "genome/creature_name.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/creature_file.h"
#include "persist/experiment/file_dimensions.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>
#include <tuple>

namespace cambrian {
namespace {

std::string account_of(const CreatureDocument& document, const EvolutionKinds& kinds) {
    if (!document.scored()) return "Not scored yet";
    const std::string& id = document.settings().goal;
    const GoalKind* goal = kinds.goals.find(id);
    const std::string name = (goal == nullptr ? capitalized(id) : goal->label) +
                             (kinds.creature.scene.dimensions == 3 ? " in space" : "");
    return fmt::format("{}, {}", name, shown_score(document.score(), document.notes.unit));
}

Sample read_sample(const std::filesystem::path& path, const EvolutionKinds& kinds) {
    const std::string file = path.filename().string();
    Sample sample;
    sample.path = path;
    sample.title = capitalized(file.substr(0, file.size() - kCreatureEnding.size()));
    std::replace(sample.title.begin(), sample.title.end(), '-', ' ');
    const auto document = load_creature(path, kinds);
    if (!document) {
        sample.account = document.error().message;
        return sample;
    }
    const Genome& genome = document->genome();
    const ExperimentSettings& settings = document->settings();
    if (!genome.name.empty()) sample.title = on_one_line(genome.name);
    sample.account = account_of(*document, kinds);
    sample.hue = genome.hue;
    sample.creature = document->creature;
    sample.kinds = &kinds;
    sample.phenotype = std::make_shared<const Phenotype>(
        express(genome, kinds.creature, settings.expression, settings.world.scene));
    return sample;
}

}  // namespace

std::vector<Sample> read_samples(const std::filesystem::path& folder, const EvolutionKinds& kinds,
                                 const EvolutionKinds* elsewhere) {
    const auto kinds_of = [&](const std::filesystem::path& path) -> const EvolutionKinds& {
        if (elsewhere == nullptr) return kinds;
        return dimensions_of_file(path) == kinds.creature.scene.dimensions ? kinds : *elsewhere;
    };
    std::vector<Sample> samples;
    std::error_code error;
    auto entry = std::filesystem::directory_iterator(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        if (entry->path().filename().string().ends_with(kCreatureEnding))
            samples.push_back(read_sample(entry->path(), kinds_of(entry->path())));
    }
    const auto order = [](const Sample& each) {
        return std::make_tuple(each.phenotype == nullptr, each.title, each.path);
    };
    std::sort(samples.begin(), samples.end(),
              [&order](const Sample& a, const Sample& b) { return order(a) < order(b); });
    return samples;
}

std::vector<Sample> read_sample_folders(const std::vector<std::filesystem::path>& folders,
                                        const std::filesystem::path& museum,
                                        const EvolutionKinds& kinds,
                                        const EvolutionKinds* elsewhere) {
    std::vector<Sample> found;
    for (const std::filesystem::path& folder : folders) {
        for (Sample& sample : read_samples(folder, kinds, elsewhere))
            found.push_back(std::move(sample));
    }
    if (!museum.empty()) {
        for (Sample& sample : read_samples(museum, kinds, elsewhere)) {
            sample.of_museum = true;
            if (sample.phenotype != nullptr) sample.title = creature_name(sample.creature.genome());
            found.push_back(std::move(sample));
        }
    }
    const auto place = [&](const Sample& sample) {
        return std::make_tuple(sample.phenotype == nullptr, sample.of_museum,
                               sample.kinds != &kinds);
    };
    std::stable_sort(found.begin(), found.end(),
                     [&place](const Sample& a, const Sample& b) { return place(a) < place(b); });
    return found;
}

}  // namespace cambrian
