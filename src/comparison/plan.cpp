#include "comparison/plan.h"

#include "persist/creature/champion_museum.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <set>

namespace cambrian {
namespace {

// An arm in a world, without a seed.
struct Contender {
    std::string world;
    std::string arm;
    ExperimentSettings settings;
};

Status check_names(const std::vector<NamedSettings>& some, std::set<std::string> taken) {
    for (const NamedSettings& each : some) {
        if (each.name.find_first_of(",\"\n\r") != std::string::npos)
            return Error{fmt::format(
                "\"{}\" cannot be written in a table; give the file another name", each.name)};
        if (!taken.insert(each.name).second)
            return Error{
                fmt::format("two are called \"{}\"; give one file another name", each.name)};
    }
    return {};
}

Result<ExperimentSettings> settings_in(const NamedSettings* world, const NamedSettings& arm,
                                       const EvolutionKinds& kinds) {
    if (world == nullptr) return merge_settings(arm.texts, kinds);
    const Result<ExperimentSettings> alone = merge_settings(world->texts, kinds);
    if (!alone) return alone.error();
    std::vector<SettingsText> texts = world->texts;
    texts.insert(texts.end(), arm.texts.begin(), arm.texts.end());
    Result<ExperimentSettings> settings = merge_settings(texts, kinds);
    if (!settings) return settings.error();
    if (settings->goal != alone->goal || settings->world.environment != alone->world.environment) {
        return Error{
            fmt::format("\"{}\" changes the goal or the environment of the world \"{}\"; expected "
                        "only what is to be compared; every further world needs --world before it",
                        arm.name, world->name)};
    }
    return settings;
}

Status add_arms(std::vector<Contender>& contenders, const NamedSettings* world,
                const ComparisonPlan& plan, const EvolutionKinds& kinds) {
    const std::size_t first = contenders.size();
    for (const NamedSettings& arm : plan.arms) {
        Result<ExperimentSettings> settings = settings_in(world, arm, kinds);
        if (!settings) return settings.error();
        const std::string name = world == nullptr ? settings->goal : world->name;
        contenders.push_back({name, arm.name, *std::move(settings)});
    }
    if (!plan.random_search) return {};
    Contender random = contenders[first];
    random.arm = kRandomSearch;
    random.settings.population.immigrants = random.settings.population.size;
    random.settings.population.museum = 0.0;
    contenders.push_back(std::move(random));
    return {};
}

Status check_goals(const std::vector<Contender>& contenders) {
    for (const Contender& one : contenders) {
        const Contender& first = contenders.front();
        if (one.world == first.world) continue;
        return Error{fmt::format(
            "\"{}\" evolves {}, \"{}\" {}; --world FILE says in which worlds to compare them",
            first.arm, first.world, one.arm, one.world)};
    }
    return {};
}

Result<std::vector<Contender>> contenders_of(const ComparisonPlan& plan,
                                             const EvolutionKinds& kinds) {
    std::vector<Contender> contenders;
    if (plan.worlds.empty()) {
        if (const Status added = add_arms(contenders, nullptr, plan, kinds); !added)
            return added.error();
        if (const Status same = check_goals(contenders); !same) return same.error();
    }
    for (const NamedSettings& world : plan.worlds) {
        if (const Status added = add_arms(contenders, &world, plan, kinds); !added)
            return added.error();
    }
    return contenders;
}

}  // namespace

Result<std::vector<PlannedRun>> planned_runs(const ComparisonPlan& plan,
                                             const EvolutionKinds& kinds) {
    std::set<std::string> taken;
    if (plan.random_search) taken.insert(kRandomSearch);
    if (const Status named = check_names(plan.arms, taken); !named) return named.error();
    if (const Status named = check_names(plan.worlds, {}); !named) return named.error();
    const Result<std::vector<Contender>> contenders = contenders_of(plan, kinds);
    if (!contenders) return contenders.error();
    if (plan.museum.empty()) {
        for (const Contender& one : *contenders) {
            if (one.settings.population.museum > 0.0) return no_museum(one.settings);
        }
    }
    std::vector<PlannedRun> runs;
    for (const std::uint64_t seed : plan.seeds) {
        for (const Contender& one : *contenders) {
            auto settings = std::make_shared<ExperimentSettings>(one.settings);
            settings->seed = seed;
            std::vector<GenomePtr> founders;
            if (settings->population.museum > 0.0)
                founders = museum_founders(plan.museum, *settings, kinds);
            runs.push_back(
                {one.world, one.arm, std::move(settings), plan.trials, std::move(founders)});
        }
    }
    return runs;
}

}  // namespace cambrian
