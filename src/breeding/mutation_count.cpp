// Draws the number of mutations of an offspring: none, one, or more with probability 1/4, 1/2, 1/4
// (breeding/README.md 1). An independent probability per gene cannot give these three values for
// any rate.

#include "breeding/mutation.h"
#include "core/assert.h"
#include "math/elementary.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr int kMaxCount = 12;
constexpr double kOneMoreShare = 1.0 / 3.0;

// Draws the count itself: 0, 1, or at least 2 with a geometric distribution.
int draw_count_first(RandomStream& stream) {
    const double u = stream.uniform();
    if (u < 0.25) return 0;
    if (u < 0.75) return 1;
    int count = 2;
    while (count < kMaxCount && stream.chance(kOneMoreShare))
        ++count;
    return count;
}

// Draws exactly one with probability g, otherwise Poisson(lambda). The equations (1 - g)
// e^-lambda = 1/4 and g + (1 - g) lambda e^-lambda = 1/2 have the solution e^lambda = lambda + 2, g
// = 1/2 - lambda / 4.
constexpr double kLambda = 1.1461932206205825;
constexpr double kExactlyOneShare = 0.5 - kLambda / 4.0;

int draw_gate(RandomStream& stream) {
    if (stream.chance(kExactlyOneShare)) return 1;
    const double stop = exponential(-kLambda);
    int count = 0;
    for (double product = stream.uniform(); product > stop && count < kMaxCount; ++count)
        product *= stream.uniform();
    return count;
}

}  // namespace

int draw_mutation_count(const MutationSettings& settings, RandomStream& stream) {
    if (!settings.mutates()) return 0;
    const double whole = std::floor(settings.rate);
    int draws = static_cast<int>(std::fmin(whole, kMaxCount));
    if (whole < settings.rate && stream.chance(settings.rate - whole)) ++draws;
    int count = 0;
    for (; draws > 0; --draws)
        count += settings.scheme == "gate" ? draw_gate(stream) : draw_count_first(stream);
    CAMBRIAN_TICK_ASSERT(count >= 0, "a count is not negative");
    return count;
}

}  // namespace cambrian
