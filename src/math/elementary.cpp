#include "math/elementary.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace cambrian {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kReducedRange = 1e6;
constexpr double kTwoPi = 2 * kPi;
constexpr double kLn2High = 0x1.62e42feep-1;  // 32 significant bits
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kLog2E = 0x1.71547652b82fep+0;
constexpr std::uint64_t kBitsOfOne = 0x3ff0000000000000ULL;
constexpr double kSqrtHalf = 0x1.6a09e667f3bcdp-1;
constexpr std::uint64_t kMantissaMask = 0x000fffffffffffffULL;
constexpr int kExponentBias = 1023;
constexpr double kTanPi12 = 0.2679491924311227;

// Returns 2^k for k in [-1022, 1023].
double power_of_two(int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + kExponentBias) << 52);
}

// Returns the arc tangent for 0 <= t <= 1. A rotation by pi/6 reduces it to |t| <= tan(pi/12) =
// 0.268, where the Taylor series to t^27 is exact to the last bit.
double arc_tangent_unit(double t) {
    const bool turned = t > kTanPi12;
    if (turned) t = (t * std::numbers::sqrt3 - 1.0) / (std::numbers::sqrt3 + t);
    const double z = t * t;
    double series = 0.0;
    for (int n = 27; n >= 3; n -= 2)
        series = (1.0 / n - series) * z;
    const double angle = t - t * series;
    return turned ? kPi / 6 + angle : angle;
}

// Returns the same angle in the range of sine_cosine_reduced(), or NaN for infinities.
double angle_in_range(double x) {
    if (std::fabs(x) <= kReducedRange) return x;
    return std::isfinite(x) ? std::fmod(x, kTwoPi) : kNaN;  // fmod is exact by the standard
}

// Returns sine(x + quarters * pi/2), with the bits of sine_cosine_reduced(), from one polynomial.
// The last terms of both functions are computed, since a branch between them would be mispredicted.
double sine_of_quarters(double x, std::uint64_t quarters) {
    using namespace elementary_detail;
    const auto [rest, found] = reduced_angle(angle_in_range(x));
    const std::uint64_t quadrant = found + quarters;
    const std::uint64_t odd = quadrant & 1;
    const double z = rest * rest;
    const double of_tail = tail(kTails[odd], z);
    const auto sine_bits = std::bit_cast<std::uint64_t>(sine_of(rest, z, of_tail));
    const auto cosine_bits = std::bit_cast<std::uint64_t>(cosine_of(z, of_tail));
    const std::uint64_t sign = (quadrant & 2) << 62;
    return std::bit_cast<double>(sine_bits ^ ((sine_bits ^ cosine_bits) & (0 - odd)) ^ sign);
}

}  // namespace

SineCosine sine_cosine(double x) {
    return sine_cosine_reduced(angle_in_range(x));
}

double sine(double x) {
    return sine_of_quarters(x, 0);
}
double cosine(double x) {
    return sine_of_quarters(x, 1);
}

double arc_tangent(double x) {
    if (std::isnan(x)) return x;
    const double size = std::fabs(x);
    const double angle =
        size <= 1.0 ? arc_tangent_unit(size) : kPi / 2 - arc_tangent_unit(1.0 / size);
    return std::copysign(angle, x);
}

double arc_tangent2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    if (x > 0.0) return arc_tangent(y / x);
    if (x < 0.0) return arc_tangent(y / x) + (y < 0.0 ? -kPi : kPi);
    if (y > 0.0) return kPi / 2;
    if (y < 0.0) return -kPi / 2;
    return 0.0;
}

double exponential(double x) {
    if (std::isnan(x)) return x;
    if (x > 709.782712893384) return kInfinity;
    if (x < -745.2) return 0.0;
    const double k = std::nearbyint(x * kLog2E);
    const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| <= 0.347
    double series = 1.0;
    for (int n = 14; n >= 1; --n)
        series = 1.0 + series * r / n;
    // Scaling by two factors is correct also near overflow and below the normal range.
    const int whole = static_cast<int>(k);
    const int half = whole / 2;
    return series * power_of_two(half) * power_of_two(whole - half);
}

double logarithm(double x) {
    if (std::isnan(x) || x < 0.0) return kNaN;
    if (x == 0.0) return -kInfinity;
    if (x == kInfinity) return x;
    int exponent = 0;
    if (x < std::numeric_limits<double>::min()) {
        x *= 0x1p54;
        exponent = -54;
    }
    const auto bits = std::bit_cast<std::uint64_t>(x);
    exponent += static_cast<int>(bits >> 52) - (kExponentBias - 1);
    double m = std::bit_cast<double>((bits & kMantissaMask) | 0x3fe0000000000000ULL);  // [1/2, 1)
    if (m < kSqrtHalf) {
        m *= 2.0;
        --exponent;
    }
    const double f = m - 1.0;
    const double s = f / (2.0 + f);  // |s| <= 0.172; ln m = 2 artanh s
    const double z = s * s;
    double series = 0.0;
    for (int n = 23; n >= 3; n -= 2)
        series = (1.0 / n + series) * z;
    const double e = exponent;
    return e * kLn2High + (2.0 * s + (2.0 * s * series + e * kLn2Low));
}

double power(double base, double exponent) {
    return exponential(exponent * logarithm(base));
}

// Newton's iteration for y^-n = x; the first guess comes from the exponent's bits.
double inverse_root(double x, int n) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto order = static_cast<std::uint64_t>(n);
    double y = std::bit_cast<double>(kBitsOfOne + kBitsOfOne / order - bits / order);
    const double share = 1.0 / n;
    for (int round = 0; round < 4; ++round) {
        double product = x;
        for (int i = 0; i < n; ++i)
            product *= y;
        y += y * (1.0 - product) * share;
    }
    return y;
}

}  // namespace cambrian
