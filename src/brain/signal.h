#pragma once

// The range of signals between neurons (brain/README.md 1).

#include <cmath>

namespace cambrian {

inline constexpr double kSignalLimit = 10.0;  // inputs and outputs are within +- this

// Returns x limited to +-10; not-a-number becomes 0.
inline double limit_signal(double x) {
    if (std::isnan(x)) return 0.0;
    const double low = x > -kSignalLimit ? x : -kSignalLimit;
    return low < kSignalLimit ? low : kSignalLimit;
}

// Two signals that are computed with together.
using SignalPair = double __attribute__((vector_size(2 * sizeof(double))));

// Limits each of the two as limit_signal() does.
inline SignalPair limit_signals(SignalPair x) {
    constexpr SignalPair kLimit = {kSignalLimit, kSignalLimit};
    const SignalPair number = x == x ? x : SignalPair{};
#ifdef __SSE2__
    return __builtin_ia32_minpd(__builtin_ia32_maxpd(number, -kLimit), kLimit);
#else
    const SignalPair low = number > -kLimit ? number : -kLimit;
    return low < kLimit ? low : kLimit;
#endif
}

// True is +1 and false is -1, as a contact sensor reads.
inline double truth(bool value) {
    return value ? 1.0 : -1.0;
}

}  // namespace cambrian
