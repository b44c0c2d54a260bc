#include "quality/plan.h"

#include "quality/arm.h"

#include <utility>

namespace cambrian::quality {
namespace {

RunSpec standard_run(const char* goal, std::string_view arm, std::uint64_t seed) {
    return {.plan = "standard", .goal = goal, .arm = std::string(arm), .seed = seed};
}

std::vector<RunSpec> standard_plan() {
    constexpr std::uint64_t kSeeds = 9;
    std::vector<RunSpec> runs;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        for (const char* goal : kGoals) {
            for (const std::string_view arm : {kEvolution, kRandomSearch})
                runs.push_back(standard_run(goal, arm, seed));
        }
    }
    for (const char* goal : kGoals)
        runs.push_back(standard_run(goal, kRepeated, 1));
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        for (const Arm& arm : all_arms()) {
            if (arm.id == kEvolution || arm.id == kRepeated || arm.id == kRandomSearch ||
                arm.id == kBlind)
                continue;
            runs.push_back(standard_run(kGoals[0], arm.id, seed));
        }
    }
    return runs;
}

std::vector<RunSpec> long_plan() {
    constexpr std::uint64_t kSeeds = 5;
    std::vector<RunSpec> runs;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        for (const char* goal : kGoals) {
            RunSpec run = {.plan = "long",
                           .goal = goal,
                           .arm = std::string(kEvolution),
                           .seed = seed,
                           .size = 300,
                           .budget = 20000,
                           .least_generations = 100};
            runs.push_back(run);
            run.arm = kRandomSearch;
            run.least_generations = 0;
            runs.push_back(run);
        }
    }
    return runs;
}

std::vector<RunSpec> quick_plan() {
    constexpr std::uint64_t kSeeds = 7;
    std::vector<RunSpec> runs;
    // Walking is won early.
    for (const auto& [goal, budget] : {std::pair{"swimming", 1500}, std::pair{"walking", 300}}) {
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
            for (const std::string_view arm : {kEvolution, kRandomSearch}) {
                runs.push_back({.plan = "quick",
                                .goal = goal,
                                .arm = std::string(arm),
                                .seed = seed,
                                .size = 60,
                                .budget = budget});
            }
        }
    }
    return runs;
}

std::vector<RunSpec> seeking_plan() {
    constexpr std::uint64_t kSeeds = 5;
    std::vector<RunSpec> runs;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        for (const std::string_view arm : {kEvolution, kBlind, kRandomSearch}) {
            runs.push_back({.plan = "seeking",
                            .goal = kSeeking,
                            .arm = std::string(arm),
                            .settings = "seeking.toml",
                            .seed = seed,
                            .size = 300,
                            .budget = 20000});
        }
    }
    return runs;
}

}  // namespace

std::vector<RunSpec> plan_of(std::string_view name) {
    if (name == "standard") return standard_plan();
    if (name == "long") return long_plan();
    if (name == "quick") return quick_plan();
    if (name == "seeking") return seeking_plan();
    return {};
}

}  // namespace cambrian::quality
