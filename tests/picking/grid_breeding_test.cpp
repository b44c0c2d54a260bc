#include "picking/grid/grid_breeding.h"

#include "picking/creatures.h"
#include "picking/grid/grid_settings.h"
#include "support/catch.h"

#include <algorithm>
#include <map>
#include <set>

using namespace cambrian;
using test::kinds;

namespace {

using Parents = std::vector<IndividualPtr>;

BroodOrder order_of(const Parents& parents, int cells = 12, int round = 0) {
    return {.parents = parents, .cells = cells, .node = 3, .round = round};
}

std::map<std::string, int> methods_of(const Brood& brood) {
    std::map<std::string, int> count;
    for (const IndividualPtr& child : brood.offspring)
        ++count[child->method];
    return count;
}

std::vector<std::uint64_t> hashes(const Brood& brood) {
    std::vector<std::uint64_t> all;
    for (const auto* group : {&brood.offspring, &brood.newcomers}) {
        for (const IndividualPtr& each : *group)
            all.push_back(each->genome_hash);
    }
    return all;
}

}  // namespace

TEST_CASE("a grid of 12 has 36 candidates in the proportions asked for", "[picking][breeding]") {
    CHECK(plan_brood(0, 12, 0) == BroodPlan{.newcomers = 36});
    CHECK(plan_brood(1, 12, 0) == BroodPlan{.copies = 36});
    CHECK(plan_brood(2, 12, 0) == BroodPlan{2, 32, 0});
    CHECK(plan_brood(3, 12, 0) == BroodPlan{2, 30, 0});
    CHECK(plan_brood(4, 12, 0) == BroodPlan{2, 28, 0});
    CHECK(plan_brood(1, 12, 2) == BroodPlan{.copies = 30, .newcomers = 6});
    CHECK(plan_brood(4, 12, 2) == BroodPlan{2, 22, 6});
}

TEST_CASE("every size of grid has three candidates a cell", "[picking][breeding]") {
    for (const int cells : kGridSizes) {
        const int newcomers = newcomer_cells({.cells = cells, .boldness = Boldness::kWild});
        for (std::size_t parents = 0; parents <= kMostPicks; ++parents) {
            const BroodPlan plan = plan_brood(parents, cells, parents > 0 ? newcomers : 0);
            CAPTURE(cells, parents);
            CHECK(plan.copies * parents + plan.paired + plan.newcomers ==
                  3 * static_cast<std::size_t>(cells));
            if (parents > 0) CHECK(plan.copies >= 2);
        }
    }
}

TEST_CASE("boldness sets extra mutations and newcomers", "[picking][breeding]") {
    CHECK(extra_mutations(Boldness::kGentle) == 0);
    CHECK(extra_mutations(Boldness::kBold) == 1);
    CHECK(extra_mutations(Boldness::kWild) == 3);
    CHECK(newcomer_cells({.cells = 12, .boldness = Boldness::kBold}) == 0);
    for (const auto& [cells, newcomers] :
         std::map<int, int>{{4, 1}, {6, 1}, {9, 2}, {12, 2}, {16, 3}, {25, 4}})
        CHECK(newcomer_cells({.cells = cells, .boldness = Boldness::kWild}) == newcomers);
}

TEST_CASE("children are bred as planned, from the picks only", "[picking][breeding]") {
    for (std::size_t count = 1; count <= kMostPicks; ++count) {
        const Parents parents = test::strangers(count);
        const Brood brood = breed_candidates(order_of(parents), {}, kinds());
        const BroodPlan plan = plan_brood(count, 12, 0);
        auto methods = methods_of(brood);
        CAPTURE(count);
        CHECK(methods["asexual"] == static_cast<int>(plan.copies * count));
        CHECK(methods["crossover"] + methods["grafting"] == static_cast<int>(plan.paired));
        CHECK(methods["crossover"] - methods["grafting"] == static_cast<int>(plan.paired % 2));
        CHECK(brood.newcomers.empty());
        std::map<std::uint64_t, int> copies;
        for (const IndividualPtr& child : brood.offspring) {
            const bool paired = child->method != "asexual";
            CHECK((child->parents[1] != 0) == paired);
            CHECK(child->parents[0] != child->parents[1]);
            if (!paired) ++copies[child->parents[0]];
            CHECK(child->born == 3);
            CHECK(validate(*child->genome, kinds().creature.catalog).empty());
        }
        for (const IndividualPtr& parent : parents)
            CHECK(copies[parent->uid] >= 2);
        CHECK(copies.size() == count);
    }
}

TEST_CASE("bolder children are mutated more often", "[picking][breeding]") {
    const Parents parents = test::strangers(1);
    for (const int extra : {0, 1, 3}) {
        double sum = 0.0;
        std::size_t least = 100;
        int children = 0;
        for (int round = 0; round < 40; ++round) {
            BroodOrder order = order_of(parents, 12, round);
            order.extra_mutations = extra;
            for (const IndividualPtr& child : breed_candidates(order, {}, kinds()).offspring) {
                sum += static_cast<double>(child->mutations.size());
                least = std::min(least, child->mutations.size());
                ++children;
            }
        }
        CHECK(sum / children == Approx(1.125 + extra).margin(0.1));
        CHECK(least == static_cast<std::size_t>(extra));
    }
}

TEST_CASE("wild broods have newcomers besides, and no picks mean newcomers only",
          "[picking][breeding]") {
    const Parents parents = test::strangers(2);
    BroodOrder order = order_of(parents);
    order.newcomer_cells = 2;
    const Brood wild = breed_candidates(order, {}, kinds());
    CHECK(wild.offspring.size() == 30);
    CHECK(wild.newcomers.size() == 6);
    const Brood fresh = breed_candidates(order_of({}), {}, kinds());
    CHECK(fresh.offspring.empty());
    REQUIRE(fresh.newcomers.size() == 36);
    for (const IndividualPtr& newcomer : fresh.newcomers)
        CHECK(newcomer->method == "random");
}

TEST_CASE("the same grid breeds the same, every other grid, round and seed others",
          "[picking][breeding]") {
    const Parents parents = test::strangers(3);
    const auto brood = [&](std::uint32_t node, int round, std::uint64_t seed) {
        BroodOrder order = order_of(parents, 12, round);
        order.node = node;
        ExperimentSettings settings;
        settings.seed = seed;
        return hashes(breed_candidates(order, settings, kinds()));
    };
    CHECK(brood(1, 0, 1) == brood(1, 0, 1));
    CHECK(brood(1, 0, 1) != brood(2, 0, 1));
    CHECK(brood(1, 0, 1) != brood(1, 1, 1));
    CHECK(brood(1, 0, 1) != brood(1, 0, 2));
}

TEST_CASE("no two creatures of picking and automatic generations have one uid",
          "[picking][breeding]") {
    const ExperimentSettings settings;
    std::set<std::uint64_t> uids;
    std::size_t count = 0;
    const auto add = [&](const std::vector<IndividualPtr>& creatures) {
        for (const IndividualPtr& each : creatures)
            uids.insert(each->uid);
        count += creatures.size();
    };
    const Parents parents = test::strangers(4, settings.seed);
    add(parents);
    const std::vector<GenomePtr> genomes(4, parents[0]->genome);
    for (std::uint32_t node = 0; node < 20; ++node) {
        add(import_creatures(genomes, node, settings));
        for (int round = 0; round < 4; ++round) {
            BroodOrder order = order_of(parents, 25, round);
            order.node = node;
            order.newcomer_cells = 4;
            const Brood brood = breed_candidates(order, settings, kinds());
            add(brood.offspring);
            add(brood.newcomers);
        }
    }
    CHECK(uids.size() == count);
}
