#include "picking/grid/grid_choice.h"

#include "core/random.h"
#include "math/distance.h"
#include "picking/grid/grid_hints.h"
#include "support/catch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace cambrian;

namespace {

using Creatures = std::vector<IndividualPtr>;

// Returns a living creature with the given descriptors.
Individual creature(std::uint64_t id, double travel, double height, double fitness = 0.0) {
    Individual each;
    Genome genome;
    genome.nodes.resize(1);
    each.uid = id;
    each.genome = std::make_shared<const Genome>(genome);
    each.genome_hash = id;
    each.evaluated = true;
    each.result.body_length = 1.0;
    each.result.mass = 1.0;
    each.result.parts = 2;
    each.result.fitness = fitness;
    each.result.behavior.stir = 1.0;
    each.result.behavior.travel = travel;
    each.result.behavior.settled_height = height;
    return each;
}

IndividualPtr shared(Individual each) {
    return std::make_shared<const Individual>(std::move(each));
}

Creatures random_creatures(std::size_t count, RandomStream& stream) {
    Creatures all;
    for (std::size_t i = 0; i < count; ++i) {
        Individual each = creature(stream.bits(), stream.uniform(), stream.uniform());
        each.result.fitness = stream.uniform();
        each.result.parts = stream.between(2, 16);
        all.push_back(shared(std::move(each)));
    }
    return all;
}

// Computes the choice by its definition, without optimisation.
std::vector<std::size_t> by_definition(const Creatures& candidates, const Creatures& shown,
                                       std::size_t count, double w) {
    Creatures all = candidates;
    all.insert(all.end(), shown.begin(), shown.end());
    const auto place = scaled_descriptors(all);
    std::vector<std::size_t> chosen;
    while (chosen.size() < count) {
        const auto open = [&](std::size_t c) {
            return std::find(chosen.begin(), chosen.end(), c) == chosen.end();
        };
        const auto spread = [&](std::size_t c) {
            double nearest = 1e9;
            for (std::size_t s = candidates.size(); s < all.size(); ++s)
                nearest = std::min(nearest, distance(place[c], place[s]));
            for (const std::size_t s : chosen)
                nearest = std::min(nearest, distance(place[c], place[s]));
            return nearest;
        };
        const auto rank = [&](std::size_t c) {
            double worse = 0.0;
            for (const IndividualPtr& other : candidates)
                worse += better(*candidates[c], *other) ? 1.0 : 0.0;
            return candidates.size() > 1 ? worse / static_cast<double>(candidates.size() - 1) : 1.0;
        };
        double greatest = 0.0;
        for (std::size_t c = 0; c < candidates.size(); ++c)
            if (open(c)) greatest = std::max(greatest, spread(c));
        const double weight = chosen.empty() && shown.empty() ? 1.0 : w;
        std::size_t best = candidates.size();
        double most = -1.0;
        for (std::size_t c = 0; c < candidates.size(); ++c) {
            if (!open(c)) continue;
            const double value =
                (1.0 - weight) * (greatest > 0.0 ? spread(c) / greatest : 0.0) + weight * rank(c);
            if (value > most + 1e-12) {
                most = value;
                best = c;
            }
        }
        chosen.push_back(best);
    }
    return chosen;
}

double least_distance(const Creatures& all, const std::vector<std::size_t>& chosen,
                      const std::vector<GridDescriptor>& place) {
    double least = 1e9;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        least = std::min(least, distance(place[chosen[i]], place[all.size() - 1]));
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, distance(place[chosen[i]], place[chosen[j]]));
    }
    return least;
}

}  // namespace

TEST_CASE("descriptors are visible quantities, scaled by their range", "[picking][choice]") {
    Individual tall = creature(1, 3.0, 0.5);
    tall.result.body_length = 2.0;
    tall.result.parts = 7;
    tall.result.mass = std::exp(2.0);
    tall.result.behavior.mean_joint_frequency = 1.5;
    const GridDescriptor seen = describe_for_grid(tall.result);
    CHECK(seen[0] == 7.0);
    CHECK(seen[1] == Approx(2.0));
    CHECK(seen[2] == 0.25);
    CHECK(seen[3] == 1.5);
    CHECK(seen[4] == 1.5);
    const Creatures all = {shared(creature(1, 0.0, 1.0)), shared(creature(2, 4.0, 1.0)),
                           shared(creature(3, 1.0, 1.0))};
    const auto scaled = scaled_descriptors(all);
    CHECK(scaled[0] == GridDescriptor{0, 0, 0, 0, 0});
    CHECK(scaled[1] == GridDescriptor{0, 0, 0, 0, 1});
    CHECK(scaled[2][4] == Approx(0.25));
    CHECK(describe_for_grid({})[2] == 0.0);  // without a length and a mass
}

TEST_CASE("the choice equals its definition for any weight of fitness", "[picking][choice]") {
    RandomStream stream(7);
    for (int i = 0; i < 300; ++i) {
        const Creatures candidates = random_creatures(1 + stream.below(8), stream);
        const Creatures shown = random_creatures(stream.below(3), stream);
        const std::size_t count = 1 + stream.below(candidates.size());
        for (const double w : {0.0, 0.3, 0.7, 1.0})
            CHECK(choose_diverse(candidates, shown, count, w) ==
                  by_definition(candidates, shown, count, w));
    }
}

TEST_CASE("the least distance among the chosen is at least half of the optimum",
          "[picking][choice]") {
    // Gonzalez (1985): the greedy choice is within a factor of two of the optimum.
    RandomStream stream(8);
    for (int i = 0; i < 100; ++i) {
        const Creatures candidates = random_creatures(8, stream);
        const Creatures shown = random_creatures(1, stream);
        Creatures all = candidates;
        all.push_back(shown.front());
        const auto place = scaled_descriptors(all);
        double best = 0.0;
        for (std::size_t a = 0; a < 8; ++a)
            for (std::size_t b = 0; b < a; ++b)
                for (std::size_t c = 0; c < b; ++c)
                    best = std::max(best, least_distance(all, {a, b, c}, place));
        const auto chosen = choose_diverse(candidates, shown, 3, 0.0);
        CHECK(least_distance(all, chosen, place) >= 0.5 * best - 1e-12);
    }
}

TEST_CASE("full weight of fitness chooses the fittest, no weight ignores fitness",
          "[picking][choice]") {
    RandomStream stream(9);
    for (int i = 0; i < 50; ++i) {
        Creatures candidates = random_creatures(20, stream);
        const Creatures shown = random_creatures(1, stream);
        std::vector<std::size_t> ranked(candidates.size());
        std::iota(ranked.begin(), ranked.end(), std::size_t{0});
        std::sort(ranked.begin(), ranked.end(), [&](std::size_t a, std::size_t b) {
            return better(*candidates[a], *candidates[b]);
        });
        ranked.resize(6);
        CHECK(choose_diverse(candidates, shown, 6, 1.0) == ranked);
        const auto mine = choose_diverse(candidates, shown, 6, 0.0);
        for (IndividualPtr& each : candidates) {
            Individual changed = *each;
            changed.result.fitness = stream.uniform();
            each = shared(std::move(changed));
        }
        CHECK(choose_diverse(candidates, shown, 6, 0.0) == mine);
    }
}

TEST_CASE("the fittest is first if no creature is displayed", "[picking][choice]") {
    const Creatures candidates = {shared(creature(1, 0.0, 0.0, 1.0)),
                                  shared(creature(2, 1.0, 0.0, 3.0)),
                                  shared(creature(3, 0.9, 0.0, 2.0))};
    CHECK(choose_diverse(candidates, {}, 2, 0.0) == std::vector<std::size_t>{1, 0});
    CHECK(choose_diverse(candidates, {}, 2, 1.0) == std::vector<std::size_t>{1, 2});
    CHECK(choose_diverse(candidates, {}, 9, 0.0).size() == 3);
    CHECK(choose_diverse({}, candidates, 2, 0.5).empty());
}

TEST_CASE("candidates with equal descriptors are chosen in their order", "[picking][choice]") {
    const Creatures same = {shared(creature(1, 1.0, 1.0)), shared(creature(2, 1.0, 1.0)),
                            shared(creature(3, 1.0, 1.0))};
    CHECK(choose_diverse(same, Creatures{same[0]}, 2, 0.0) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("dead, equal and invalid candidates are distinguished from living ones",
          "[picking][choice]") {
    Individual still = creature(1, 0.0, 1.0);
    still.result.behavior.stir = 0.009;
    Individual stirring = creature(2, 0.0, 1.0);
    stirring.result.behavior.stir = 0.011;
    Individual stiff = creature(3, 0.0, 1.0);
    stiff.result.outcome = Outcome::kRejected;
    Individual diverged = creature(4, 0.0, 1.0);
    diverged.result.outcome = Outcome::kDiverged;
    const Creatures candidates = {shared(still),
                                  shared(stirring),
                                  shared(stiff),
                                  shared(diverged),
                                  shared(creature(2, 5.0, 1.0)),
                                  shared(creature(9, 5.0, 1.0))};
    using enum CandidateGrade;
    CHECK(grade_candidates(candidates, {9}) ==
          std::vector<CandidateGrade>{kStatic, kAlive, kRejected, kInvalid, kTwin, kTwin});
}

TEST_CASE("badges mark the creatures with extreme measures", "[picking][hints]") {
    const Creatures grid = {shared(creature(1, 0.1, 0.2)), shared(creature(2, 2.0, 0.2)),
                            shared(creature(3, 0.1, 0.9)), shared(creature(4, 0.2, 0.3))};
    const GridHints hints = grid_hints(grid);
    CHECK(hints.fastest == 1U);
    CHECK(hints.highest == 2U);
    CHECK((hints.oddest == 1U || hints.oddest == 2U));
    CHECK_FALSE(grid_hints({}).fastest);
    const Creatures alike = {shared(creature(1, 0.0, 0.0)), shared(creature(2, 0.0, 0.0))};
    CHECK_FALSE(grid_hints(alike).oddest);
    for (const Outcome outcome : {Outcome::kDisqualified, Outcome::kStoppedEarly}) {
        Individual odd = creature(5, 9.0, 9.0);  // by a motion that does not count
        odd.result.outcome = outcome;
        Creatures more = grid;
        more.push_back(shared(odd));
        const GridHints others = grid_hints(more);
        CHECK(others.fastest == 1U);
        CHECK(others.highest == 2U);
        CHECK(others.oddest != 4U);
    }
}
