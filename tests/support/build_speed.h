#pragma once

// Amounts of work that depend on the build.

namespace cambrian::test {

// Returns the first amount in optimised builds. Builds with assertions and sanitizers take ten to
// thirty times as long and look for other faults than an optimised build does: fewer random cases,
// smaller populations and shorter trials suffice there.
template <typename Amount>
constexpr Amount by_build([[maybe_unused]] Amount optimised, [[maybe_unused]] Amount checked) {
#ifdef NDEBUG
    return optimised;
#else
    return checked;
#endif
}

}  // namespace cambrian::test
