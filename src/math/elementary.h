#pragma once

// Elementary functions that give the same bits on every machine, with every compiler and
// optimisation level. They use polynomials in the four exactly rounded operations, never libm.
// Errors are stated for the given domain; NaN gives NaN.

#include <array>
#include <bit>
#include <cstdint>

namespace cambrian {

inline constexpr double kPi = 3.14159265358979323846;

struct SineCosine {
    double sine;
    double cosine;
};

namespace elementary_detail {

inline constexpr double kRoundingMagic = 0x1.8p52;
inline constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
// pi/2 in three parts; the first two have 33 significant bits, so that k * part is exact for
// |k| < 2^20 (Cody & Waite 1980).
inline constexpr double kHalfPiHigh = 0x1.921fb544p+0;
inline constexpr double kHalfPiMiddle = 0x1.0b4611a6p-34;
inline constexpr double kHalfPiLow = 0x1.3198a2e037073p-69;

// x = quadrant * pi/2 + rest, |rest| <= pi/4. Only the last two bits of the quadrant count.
struct ReducedAngle {
    double rest;
    std::uint64_t quadrant;
};

inline ReducedAngle reduced_angle(double x) {
    const double shifted = x * kTwoOverPi + kRoundingMagic;
    const double k = shifted - kRoundingMagic;
    return {((x - k * kHalfPiHigh) - k * kHalfPiMiddle) - k * kHalfPiLow,
            std::bit_cast<std::uint64_t>(shifted)};
}

// Taylor polynomials of sine and cosine on [-pi/4, pi/4], of z = x^2, without their first terms;
// the first omitted terms are below 1e-19 and 3e-18.
using Tail = std::array<double, 7>;
inline constexpr std::array<Tail, 2> kTails{
    Tail{-1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800,
         -1.0 / 1307674368000.0},
    Tail{1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200.0,
         1.0 / 20922789888000.0}};

inline double tail(const Tail& of, double z) {
    return of[0] + z * (of[1] + z * (of[2] + z * (of[3] + z * (of[4] + z * (of[5] + z * of[6])))));
}
inline double sine_of(double rest, double z, double sine_tail) {
    return rest + rest * z * sine_tail;
}
inline double cosine_of(double z, double cosine_tail) {
    return 1.0 - (0.5 * z - z * z * cosine_tail);
}

}  // namespace elementary_detail

// For |x| <= 1e6, the absolute error is below 2e-16. There are no branches, so loops vectorise.
// Larger |x| must use sine() or cosine().
inline SineCosine sine_cosine_reduced(double x) {
    using namespace elementary_detail;
    const auto [rest, quadrant] = reduced_angle(x);
    const double z = rest * rest;
    const double s = sine_of(rest, z, tail(kTails[0], z));
    const double c = cosine_of(z, tail(kTails[1], z));
    // quadrant 0: (s, c), 1: (c, -s), 2: (-s, -c), 3: (-c, s)
    const std::uint64_t swap = 0 - (quadrant & 1);  // all bits, or none
    const std::uint64_t sine_sign = (quadrant & 2) << 62;
    const std::uint64_t cosine_sign = ((quadrant + 1) & 2) << 62;
    const auto s_bits = std::bit_cast<std::uint64_t>(s);
    const auto c_bits = std::bit_cast<std::uint64_t>(c);
    const std::uint64_t exchanged = (s_bits ^ c_bits) & swap;
    return {std::bit_cast<double>(s_bits ^ exchanged ^ sine_sign),
            std::bit_cast<double>(c_bits ^ exchanged ^ cosine_sign)};
}

SineCosine sine_cosine(double x);  // any finite x; NaN for infinities
double sine(double x);
double cosine(double x);
double arc_tangent(double x);             // absolute error below 4e-16
double arc_tangent2(double y, double x);  // (-pi, pi], as std::atan2; (0, 0) gives 0
double exponential(double x);  // relative error below 4e-16; 0 or infinity beyond the range
double logarithm(
    double x);  // natural; relative error below 4e-16; x < 0 gives NaN, 0 gives -infinity
double power(double base, double exponent);  // base > 0; exp(exponent * ln base)
// x^(-1/n) for normal x > 0 and n from 1 to 8; relative error below 1e-7. Faster than power().
double inverse_root(double x, int n);

}  // namespace cambrian
