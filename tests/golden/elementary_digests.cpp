#include "core/hash.h"
#include "core/random.h"
#include "golden/golden.h"
#include "math/angle.h"
#include "math/elementary.h"
#include "math/reflect.h"

#include <array>
#include <cmath>
#include <limits>

namespace cambrian::golden {
namespace {

constexpr int kGridPoints = 20000;
constexpr int kPatterns = 20000;

struct Function {
    const char* name;
    double (*evaluate)(double);
    double low, high;  // range of the grid
};

double power_of_three_halves(double x) {
    return power(x, 1.5);
}
double sine_and_cosine(double x) {
    const SineCosine both = sine_cosine_reduced(x);
    return both.sine - 0.5 * both.cosine;
}
double wrapped(double x) {
    return wrap_angle(std::fmod(x, 1e6));
}
double reflected(double x) {
    return reflect(x, -0.7, 1.1);
}

constexpr std::array kFunctions = {
    Function{"sine", sine, -100.0, 100.0},
    Function{"cosine", cosine, -1e6, 1e6},
    Function{"arc_tangent", arc_tangent, -20.0, 20.0},
    Function{"exponential", exponential, -750.0, 712.0},
    Function{"logarithm", logarithm, 0.0, 100.0},
    Function{"power", power_of_three_halves, 0.0, 50.0},
    Function{"wrap_angle", wrapped, -1e3, 1e3},
    Function{"reflect", reflected, -10.0, 10.0},
};

// Processors choose payload and sign of not-a-number freely, so these do not count.
void add_number(Hash64& hash, double number) {
    hash.add(std::isnan(number) ? std::numeric_limits<double>::quiet_NaN() : number);
}

// Returns any finite number with a random bit pattern.
double random_pattern(RandomStream& random) {
    double number = 0.0;
    do {
        number = std::bit_cast<double>(random.bits());
    } while (!std::isfinite(number));
    return number;
}

std::uint64_t digest_of(const Function& function) {
    Hash64 hash;
    const double step = (function.high - function.low) / kGridPoints;
    for (int i = 0; i <= kGridPoints; ++i)
        add_number(hash, function.evaluate(function.low + step * i));
    RandomStream random(stream_seed({1}));
    for (int i = 0; i < kPatterns; ++i)
        add_number(hash, function.evaluate(random_pattern(random)));
    using Limits = std::numeric_limits<double>;
    for (const double special : {0.0, -0.0, Limits::denorm_min(), Limits::min(), Limits::max()})
        add_number(hash, function.evaluate(special));
    return hash.value();
}

// Calls the function over an array, as physics does, so that the compiler may vectorise it.
std::uint64_t digest_of_reduced_sines() {
    std::array<double, 1024> sums{};
    Hash64 hash;
    for (int round = 0; round < 20; ++round) {
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += sine_and_cosine(0.37 * static_cast<double>(i) - 50.0 * round);
        for (const double sum : sums)
            hash.add(sum);
    }
    return hash.value();
}

std::uint64_t digest_of_directions() {
    Hash64 hash;
    RandomStream random(stream_seed({2}));
    for (int i = 0; i < kGridPoints; ++i) {
        const double y = random.uniform(-2.0, 2.0);
        hash.add(arc_tangent2(y, random.uniform(-2.0, 2.0)));
    }
    for (const double y : {-1.0, -0.0, 0.0, 1.0}) {
        for (const double x : {-1.0, -0.0, 0.0, 1.0})
            hash.add(arc_tangent2(y, x));
    }
    return hash.value();
}

std::uint64_t digest_of_draws() {
    Hash64 hash;
    RandomStream random(stream_seed({3}));
    const std::array weights = {0.1, 0.0, 2.5, 1.0 / 3};
    for (int i = 0; i < kGridPoints; ++i) {
        hash.add(random.uniform(-0.3, 0.7));
        hash.add(random.gauss());
        hash.add(std::uint64_t{random.below(static_cast<std::size_t>(i) + 1)});
        hash.add(std::uint64_t{random.weighted(weights)});
    }
    return hash.value();
}

}  // namespace

void add_elementary_digests(Digests& digests) {
    for (const Function& function : kFunctions)
        digests.push_back({std::string("elementary.") + function.name, digest_of(function)});
    digests.push_back({"elementary.sine_cosine_reduced", digest_of_reduced_sines()});
    digests.push_back({"elementary.arc_tangent2", digest_of_directions()});
    digests.push_back({"random.draws", digest_of_draws()});
}

}  // namespace cambrian::golden
