#include "persist/creature/champion_museum.h"

#include "core/random.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/rescoring.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>

namespace cambrian {
namespace {

namespace fs = std::filesystem;

// Returns the creature files of a folder in the order of their names.
std::vector<fs::path> exhibits_of(const fs::path& museum) {
    std::vector<fs::path> files;
    std::error_code error;
    auto entry = fs::directory_iterator(museum, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        if (entry->path().filename().string().ends_with(kCreatureEnding))
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string ending_of_plan(std::uint64_t plan) {
    return fmt::format("-{:016x}{}", plan, kCreatureEnding);
}

// Whether a creature of the museum keeps its place against another one of its body plan.
bool keeps_place(const fs::path& file, const CreatureDocument& other, const EvolutionKinds& kinds) {
    const Result<CreatureDocument> old = load_creature(file, kinds);
    if (!old) return false;
    const ExperimentSettings& a = old->settings();
    const ExperimentSettings& b = other.settings();
    const bool comparable = a.goal == b.goal && a.world.environment == b.world.environment;
    return !comparable || old->score() >= other.score();
}

}  // namespace

std::string_view words_of(Admission admission) {
    switch (admission) {
        case Admission::kNew:
            return "the champion's body plan is new, so it stays here";
        case Admission::kInPlace:
            return "the champion takes the place of a weaker one with its body plan";
        case Admission::kKnown:
            return "a creature with the champion's body plan is here already";
        case Admission::kNotEligible:
            return "the champion is not taken, since its trial is incomplete or suspect";
        case Admission::kFull:
            return "the champion is not taken, since all 1000 places are filled";
    }
    return "";
}

Result<Admission> admit(const fs::path& museum, const CreatureDocument& champion,
                        const EvolutionKinds& kinds, const std::stop_token& stop) {
    if (!champion.scored() || champion.result().outcome != Outcome::kCompleted ||
        champion.result().verdict != AuditVerdict::kClean)
        return Admission::kNotEligible;
    const std::string ending = ending_of_plan(champion.result().plan);
    const std::vector<fs::path> files = exhibits_of(museum);
    const auto old = std::find_if(files.begin(), files.end(), [&](const fs::path& file) {
        return file.filename().string().ends_with(ending);
    });
    if (old != files.end() && keeps_place(*old, champion, kinds)) return Admission::kKnown;
    if (old == files.end() && files.size() >= kMuseumPlaces) return Admission::kFull;
    const EvaluationResult again = run_scored_trial(champion, kinds, stop);
    if (stop.stop_requested()) return Error{"interrupted; the museum is as before"};
    if (again.digest != champion.result().digest || again.fitness != champion.score())
        return Error{"the champion's score is not repeated, so the museum does not take it"};
    std::error_code error;
    fs::create_directories(museum, error);
    if (error) return Error{fmt::format("{}: {}", museum.string(), error.message())};
    const fs::path file = museum / (champion.settings().goal + ending);
    if (const Status saved = save_creature(file, champion, kinds); !saved) return saved.error();
    if (old == files.end()) return Admission::kNew;
    if (*old != file) fs::remove(*old, error);
    return Admission::kInPlace;
}

std::vector<GenomePtr> museum_founders(const fs::path& museum, const ExperimentSettings& settings,
                                       const EvolutionKinds& kinds) {
    const auto wanted = static_cast<std::size_t>(
        std::lround(settings.population.museum * settings.population.size));
    std::vector<fs::path> files = exhibits_of(museum);
    RandomStream stream(stream_seed(settings.seed, 0, 0, Purpose::kMuseum));
    stream.shuffle(std::span(files));
    std::vector<GenomePtr> founders;
    for (const fs::path& file : files) {
        if (founders.size() >= wanted) break;
        const Result<std::string> text = read_creature_text(file);
        if (!text || dimensions_of_creature(*text) != kinds.creature.scene.dimensions) continue;
        const auto document = parse_creature(*text, file.string(), kinds);
        if (document) founders.push_back(document->creature.individual->genome);
    }
    return founders;
}

Error no_museum(const ExperimentSettings& settings) {
    return {
        fmt::format("[population] museum is {:g}, so founders come from a museum; expected its "
                    "folder, by --museum FOLDER",
                    settings.population.museum)};
}

}  // namespace cambrian
