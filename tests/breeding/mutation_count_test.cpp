// The scheme of breeding/README.md 1: a quarter of all offspring is not mutated, a half once.

#include "breeding/corpora.h"
#include "support/build_speed.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

constexpr int kDraws = test::by_build(20'000, 4'000);
constexpr double kCritical = 18.42;  // quantile of chi-square for 2 degrees of freedom, p = 1e-4

// Returns the sum over {0, 1, more} of (seen - expected)^2 / expected.
double chi_square(const std::array<int, 3>& seen) {
    constexpr std::array<double, 3> expected = {0.25 * kDraws, 0.5 * kDraws, 0.25 * kDraws};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
    return sum;
}

template <class Draw>
double chi_square_of(Draw draw) {
    std::array<int, 3> seen{};
    for (int i = 0; i < kDraws; ++i)
        ++seen[static_cast<std::size_t>(std::min(draw(), 2))];
    return chi_square(seen);
}

double chi_square_of_scheme(const std::string& scheme) {
    RandomStream stream = test_stream(1);
    return chi_square_of([&] { return draw_mutation_count({.scheme = scheme}, stream); });
}

void check_mutations_of(const std::vector<Genome>& corpus) {
    const MutationRegistry kinds = builtin_mutations();
    RandomStream stream = test_stream(2);
    std::array<int, 3> seen{};
    int unchanged = 0;
    for (int i = 0; i < kDraws; ++i) {
        Genome child = corpus[static_cast<std::size_t>(i) % corpus.size()];
        const std::uint64_t before = genome_hash(child);
        const std::size_t count = mutate(child, {}, kinds, default_context(), stream).size();
        ++seen[std::min<std::size_t>(count, 2)];
        unchanged += genome_hash(child) == before;
    }
    CHECK(chi_square(seen) < kCritical);
    CHECK(unchanged == seen[0]);
}

}  // namespace

TEST_CASE("both exact schemes meet the seed's quarters", "[breeding][mutation]") {
    CHECK(chi_square_of_scheme("count-first") < kCritical);
    CHECK(chi_square_of_scheme("gate") < kCritical);
}

TEST_CASE("independent chances, the control, fail the same test", "[breeding][mutation]") {
    RandomStream stream = test_stream(3);
    const auto poisson = [&] {
        int count = 0;
        for (double product = stream.uniform(); product > 0.25; ++count)  // e^-ln 4
            product *= stream.uniform();
        return count;
    };
    CHECK(chi_square_of(poisson) > kCritical);
}

TEST_CASE("single parts mutate by the exact scheme", "[breeding][mutation]") {
    check_mutations_of(single_part_corpus(20));
}
TEST_CASE("founders mutate by the exact scheme", "[breeding][mutation]") {
    check_mutations_of(founder_corpus(20));
}
TEST_CASE("evolved genomes mutate by the exact scheme", "[breeding][mutation]") {
    check_mutations_of(evolved_corpus(20));
}

TEST_CASE("the rate multiplies the number of mutations, 0 and none stop them",
          "[breeding][mutation]") {
    RandomStream stream = test_stream(4);
    const auto mean = [&](const MutationSettings& settings) {
        double sum = 0.0;
        for (int i = 0; i < kDraws; ++i)
            sum += draw_mutation_count(settings, stream);
        return sum / kDraws;
    };
    CHECK(mean({}) == Approx(1.125).margin(0.03));
    CHECK(mean({.rate = 2.0}) == Approx(2.25).margin(0.05));
    CHECK(mean({.rate = 0.5}) == Approx(0.5625).margin(0.03));
    CHECK(mean({.rate = 0.0}) == 0.0);
    CHECK(mean({.scheme = "none"}) == 0.0);
}
