#include "brain/functions/families.h"
#include "brain/signal.h"
#include "math/elementary.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kLeakTime = 10.0;         // s; makes an integrator leave its limit
constexpr double kMaxSmoothingTime = 5.0;  // s

double integrate(const double* in, double* memory, double dt) {
    memory[0] = limit_signal(memory[0] * (1.0 - dt / kLeakTime) + in[0] * dt);
    return memory[0];
}

// The memory has the previous input, and whether there is one.
double differentiate(const double* in, double* memory, double dt) {
    const double rate = memory[1] != 0.0 ? (in[0] - memory[0]) / dt : 0.0;
    memory[0] = in[0];
    memory[1] = 1.0;
    return rate;
}

double smooth(const double* in, double* memory, double dt) {
    const double time = std::fmin(std::fmax(std::fabs(in[1]), dt), kMaxSmoothingTime);
    memory[0] += (in[0] - memory[0]) * (1.0 - exponential(-dt / time));
    return memory[0];
}

// Samples the first input while the second is positive, and holds it otherwise.
double remember(const double* in, double* memory, double /*dt*/) {
    if (in[1] > 0.0) memory[0] = in[0];
    return memory[0];
}

}  // namespace

void add_temporal_functions(NeuronFunctionRegistry& functions) {
    functions.add({.id = "integrate",
                   .label = "Integrate",
                   .arity = 1,
                   .memory_size = 1,
                   .evaluate = integrate});
    functions.add({.id = "differentiate",
                   .label = "Differentiate",
                   .arity = 1,
                   .memory_size = 2,
                   .evaluate = differentiate});
    functions.add(
        {.id = "smooth", .label = "Smooth", .arity = 2, .memory_size = 1, .evaluate = smooth});
    functions.add(
        {.id = "memory", .label = "Memory", .arity = 2, .memory_size = 1, .evaluate = remember});
}

}  // namespace cambrian
