#include "persist/page/run_page.h"

#include "persist/experiment/experiment_parts.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {

Result<PageContent> content_of_run(const std::filesystem::path& run, const EvolutionKinds& kinds,
                                   const TrialWatch& watch) {
    auto history = load_history(run);
    if (!history) return history.error();
    PageContent content;
    content.title = "Champions of " + run.stem().string();
    for (const std::uint32_t generation :
         spread_generations(history->back().generation, kPageChampions)) {
        Result<KeptChampion> kept = load_champion(run, generation, kinds);
        if (!kept) return kept.error();
        PageCreature shown{.document = creature_document(std::move(kept->creature), kinds),
                           .label = fmt::format("generation {}", generation),
                           .generation = generation};
        shown.document.notes.simulator = kept->simulator;
        complete_score(shown.document, kinds, watch.stop);
        if (watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
        content.creatures.insert(content.creatures.begin(), std::move(shown));
        watch.note(static_cast<double>(content.creatures.size()));
    }
    const ExperimentSettings& settings = content.creatures.front().document.settings();
    content.course = PageCourse{*std::move(history), goal_unit(settings.goal, kinds.goals)};
    return content;
}

PageContent content_of_creature(CreatureDocument document, const std::string& title) {
    PageContent content;
    content.title = title;
    content.creatures.push_back({.document = std::move(document), .label = title});
    return content;
}

}  // namespace cambrian
