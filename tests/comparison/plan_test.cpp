#include "comparison/plan.h"

#include "support/catch.h"
#include "support/kinds.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

NamedSettings named(const std::string& name, const std::string& text) {
    return {name, {{text, name + ".toml"}}};
}

std::string message_of(const ComparisonPlan& plan) {
    const auto runs = planned_runs(plan, kinds());
    return runs ? "no error" : runs.error().message;
}

const NamedSettings kMoon = named("moon", "[environment]\ngravity = 1.62\n");
const NamedSettings kWater = named("water", "[goal]\nbehavior = \"swimming\"\n");
const NamedSettings kSmall = named("small", "[population]\nsize = 40\n");
const NamedSettings kPlain = named("plain", "");

}  // namespace

TEST_CASE("runs that take founders from a museum need one", "[comparison]") {
    const NamedSettings visitor = named("visitor", "[population]\nmuseum = 0.2\n");
    ComparisonPlan plan = {
        .worlds = {kMoon}, .arms = {kPlain, visitor}, .seeds = {1}, .trials = 10};
    CHECK(message_of(plan).find("[population] museum is 0.2") == 0);
    plan.museum = std::string(CAMBRIAN_SOURCE_DIR) + "/assets/creatures";
    const auto runs = planned_runs(plan, kinds());
    REQUIRE(runs);
    CHECK((*runs)[0].founders.empty());
    CHECK((*runs)[1].founders.size() > 10);
    const auto row = planned_row((*runs)[1], kinds());
    PlannedRun without = (*runs)[1];
    without.founders.pop_back();
    CHECK_FALSE(is_row_of(row, planned_row(without, kinds())));
}

TEST_CASE("every arm is run in every world with every seed", "[comparison]") {
    const auto runs = planned_runs({.worlds = {kMoon, kWater},
                                    .arms = {kPlain, kSmall},
                                    .random_search = true,
                                    .seeds = {4, 7},
                                    .trials = 500},
                                   kinds());
    REQUIRE(runs);
    REQUIRE(runs->size() == 12);
    const PlannedRun& small = (*runs)[1];
    CHECK(small.world == "moon");
    CHECK(small.arm == "small");
    CHECK(small.trials == 500);
    CHECK(small.settings->seed == 4);
    CHECK(small.settings->population.size == 40);
    CHECK(small.settings->world.environment.gravity == 1.62);
    const PlannedRun& random = (*runs)[2];
    CHECK(random.arm == kRandomSearch);
    CHECK(random.settings->population.immigrants == random.settings->population.size);
    // Settings that follow from a goal follow from the world's goal.
    CHECK((*runs)[0].settings->selection.confirmations == 2);
    CHECK((*runs)[3].settings->selection.confirmations == 0);
    CHECK((*runs)[3].settings->goal == "swimming");
    CHECK((*runs)[11].settings->seed == 7);
}

TEST_CASE("without a world each arm says it itself", "[comparison]") {
    const auto runs = planned_runs({.arms = {kPlain, kMoon}, .seeds = {1}, .trials = 1}, kinds());
    REQUIRE(runs);
    CHECK((*runs)[1].world == "walking");
    CHECK((*runs)[1].settings->world.environment.gravity == 1.62);
    CHECK(message_of({.arms = {kPlain, kWater}, .seeds = {1}, .trials = 1}) ==
          "\"plain\" evolves walking, \"water\" swimming; --world FILE says in which worlds to "
          "compare them");
}

TEST_CASE("an arm may not change its world, nor two things have a name", "[comparison]") {
    CHECK(message_of({.worlds = {kWater}, .arms = {kMoon}, .seeds = {1}, .trials = 1}) ==
          "\"moon\" changes the goal or the environment of the world \"water\"; expected only "
          "what is to be compared; every further world needs --world before it");
    CHECK(message_of({.arms = {kPlain, kPlain}, .seeds = {1}, .trials = 1}) ==
          "two are called \"plain\"; give one file another name");
    const NamedSettings random = named(kRandomSearch, "");
    CHECK(message_of({.arms = {random}, .seeds = {1}, .trials = 1}) == "no error");
    CHECK(message_of({.arms = {random}, .random_search = true, .seeds = {1}, .trials = 1}) ==
          "two are called \"random-search\"; give one file another name");
    CHECK(message_of({.arms = {named("a,b", "")}, .seeds = {1}, .trials = 1}) ==
          "\"a,b\" cannot be written in a table; give the file another name");
    CHECK(message_of(
              {.arms = {named("bad", "[environment]\ngravity = -1\n")}, .seeds = {1}, .trials = 1})
              .starts_with("bad.toml: line 2, [environment] gravity: "));
}
