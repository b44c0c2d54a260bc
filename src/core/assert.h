#pragma once

// Assertions for bugs in our own code, never for user input. They are always on, except the tick
// variant, which is only in debug and sanitizer builds, since it is used in the simulation's inner
// loop.

#include <cstdio>
#include <cstdlib>

namespace cambrian {

[[noreturn]] inline void assertion_failed(const char* condition, const char* why, const char* file,
                                          int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s (%s)\n", file, line, condition, why);
    std::abort();
}

}  // namespace cambrian

#define CAMBRIAN_ASSERT(condition, why) \
    ((condition) ? static_cast<void>(0) \
                 : ::cambrian::assertion_failed(#condition, why, __FILE__, __LINE__))

#ifdef CAMBRIAN_TICK_ASSERTS
#define CAMBRIAN_TICK_ASSERT(condition, why) CAMBRIAN_ASSERT(condition, why)
#else
#define CAMBRIAN_TICK_ASSERT(condition, why) static_cast<void>(0)
#endif
