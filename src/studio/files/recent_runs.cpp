#include "studio/files/recent_runs.h"

#include "core/text/code_points.h"
#include "core/text/counted.h"
#include "core/text/shown_score.h"
#include "persist/experiment/experiment_parts.h"
#include "persist/preserve/preserve_file.h"
#include "persist/settings/challenge_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>

namespace cambrian {

void use_run(std::vector<std::filesystem::path>& paths, const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::path whole = std::filesystem::absolute(path, ignored);
    std::erase(paths, whole);
    paths.insert(paths.begin(), whole);
    if (paths.size() > kMostRecent) paths.resize(kMostRecent);
}

std::vector<std::filesystem::path> challenges_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> found;
    std::error_code error;
    auto entry = std::filesystem::directory_iterator(folder, error);
    for (const auto end = std::filesystem::directory_iterator(); !error && entry != end;
         entry.increment(error)) {
        if (entry->path().string().ends_with(kChallengeEnding)) found.push_back(entry->path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

RecentRun read_run(const std::filesystem::path& path, const EvolutionKinds& kinds) {
    RecentRun run;
    run.path = path;
    run.title = on_one_line(path.stem().string());
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) {
        run.account = "The file is no longer there.";
        return run;
    }
    if (is_preserve_file(path)) {
        run.account = "A preserve";
        run.readable = true;
        return run;
    }
    const auto champion = load_champion(path, std::nullopt, kinds);
    if (!champion) {
        run.account = on_one_line(champion.error().message);
        return run;
    }
    run.readable = true;
    const JudgedIndividual& creature = champion->creature;
    const GoalKind* goal = kinds.goals.find(creature.settings->goal);
    run.account = fmt::format(
        "{}, {}, {}", goal == nullptr ? creature.settings->goal : goal->label,
        shown_score(creature.individual->result.fitness, goal == nullptr ? "" : goal->unit),
        counted(creature.generation + std::size_t{1}, "generation"));
    run.hue = creature.genome().hue;
    run.line = creature.individual->line;
    run.champion = std::make_shared<const Phenotype>(express(creature.genome(), kinds.creature,
                                                             creature.settings->expression,
                                                             creature.settings->world.scene));
    return run;
}

}  // namespace cambrian
