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

CandidateOrder order_of(const Parents& parents, int cells = 12, int round = 0) {
    return {.parents = parents, .cells = cells, .node = 3, .round = round};
}

std::map<std::string, int> methods_of(const Candidates& candidates) {
    std::map<std::string, int> count;
    for (const IndividualPtr& child : candidates.offspring)
        ++count[child->method];
    return count;
}

std::vector<std::uint64_t> hashes(const Candidates& candidates) {
    std::vector<std::uint64_t> all;
    for (const auto* group : {&candidates.offspring, &candidates.immigrants}) {
        for (const IndividualPtr& each : *group)
            all.push_back(each->genome_hash);
    }
    return all;
}

}  // namespace

TEST_CASE("a grid of 12 has 36 candidates in the planned proportions", "[picking][breeding]") {
    CHECK(plan_candidates(0, 12, 0) == CandidatePlan{.immigrants = 36});
    CHECK(plan_candidates(1, 12, 0) == CandidatePlan{.copies = 36});
    CHECK(plan_candidates(2, 12, 0) == CandidatePlan{2, 32, 0});
    CHECK(plan_candidates(3, 12, 0) == CandidatePlan{2, 30, 0});
    CHECK(plan_candidates(4, 12, 0) == CandidatePlan{2, 28, 0});
    CHECK(plan_candidates(1, 12, 2) == CandidatePlan{.copies = 30, .immigrants = 6});
    CHECK(plan_candidates(4, 12, 2) == CandidatePlan{2, 22, 6});
}

TEST_CASE("every size of grid has three candidates a cell", "[picking][breeding]") {
    for (const int cells : kGridSizes) {
        const int immigrants = immigrant_cells({.cells = cells, .boldness = Boldness::kWild});
        for (std::size_t parents = 0; parents <= kMostPicks; ++parents) {
            const CandidatePlan plan =
                plan_candidates(parents, cells, parents > 0 ? immigrants : 0);
            CAPTURE(cells, parents);
            CHECK(plan.copies * parents + plan.paired + plan.immigrants ==
                  3 * static_cast<std::size_t>(cells));
            if (parents > 0) CHECK(plan.copies >= 2);
        }
    }
}

TEST_CASE("boldness sets the numbers of extra mutations and of random immigrants",
          "[picking][breeding]") {
    CHECK(extra_mutations(Boldness::kGentle) == 0);
    CHECK(extra_mutations(Boldness::kBold) == 1);
    CHECK(extra_mutations(Boldness::kWild) == 3);
    CHECK(immigrant_cells({.cells = 12, .boldness = Boldness::kBold}) == 0);
    for (const auto& [cells, immigrants] :
         std::map<int, int>{{4, 1}, {6, 1}, {9, 2}, {12, 2}, {16, 3}, {25, 4}})
        CHECK(immigrant_cells({.cells = cells, .boldness = Boldness::kWild}) == immigrants);
}

TEST_CASE("children are bred as planned, from the picks only", "[picking][breeding]") {
    for (std::size_t count = 1; count <= kMostPicks; ++count) {
        const Parents parents = test::strangers(count);
        const Candidates candidates = breed_candidates(order_of(parents), {}, kinds());
        const CandidatePlan plan = plan_candidates(count, 12, 0);
        auto methods = methods_of(candidates);
        CAPTURE(count);
        CHECK(methods["asexual"] == static_cast<int>(plan.copies * count));
        CHECK(methods["crossover"] + methods["grafting"] == static_cast<int>(plan.paired));
        CHECK(methods["crossover"] - methods["grafting"] == static_cast<int>(plan.paired % 2));
        CHECK(candidates.immigrants.empty());
        std::map<std::uint64_t, int> copies;
        for (const IndividualPtr& child : candidates.offspring) {
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
            CandidateOrder order = order_of(parents, 12, round);
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

TEST_CASE("wild grids also have random immigrants, and grids without picks nothing else",
          "[picking][breeding]") {
    const Parents parents = test::strangers(2);
    CandidateOrder order = order_of(parents);
    order.immigrant_cells = 2;
    const Candidates wild = breed_candidates(order, {}, kinds());
    CHECK(wild.offspring.size() == 30);
    CHECK(wild.immigrants.size() == 6);
    const Candidates fresh = breed_candidates(order_of({}), {}, kinds());
    CHECK(fresh.offspring.empty());
    REQUIRE(fresh.immigrants.size() == 36);
    for (const IndividualPtr& immigrant : fresh.immigrants)
        CHECK(immigrant->method == "random");
}

TEST_CASE("candidates follow from the grid, its round and the seed, and differ between them",
          "[picking][breeding]") {
    const Parents parents = test::strangers(3);
    const auto candidates = [&](std::uint32_t node, int round, std::uint64_t seed) {
        CandidateOrder order = order_of(parents, 12, round);
        order.node = node;
        ExperimentSettings settings;
        settings.seed = seed;
        return hashes(breed_candidates(order, settings, kinds()));
    };
    CHECK(candidates(1, 0, 1) == candidates(1, 0, 1));
    CHECK(candidates(1, 0, 1) != candidates(2, 0, 1));
    CHECK(candidates(1, 0, 1) != candidates(1, 1, 1));
    CHECK(candidates(1, 0, 1) != candidates(1, 0, 2));
}

TEST_CASE("no creatures of picking and of automatic generations share a uid",
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
            CandidateOrder order = order_of(parents, 25, round);
            order.node = node;
            order.immigrant_cells = 4;
            const Candidates candidates = breed_candidates(order, settings, kinds());
            add(candidates.offspring);
            add(candidates.immigrants);
        }
    }
    CHECK(uids.size() == count);
}
