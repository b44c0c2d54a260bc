// Input a is the frequency in Hz, b the phase in cycles; the amplitude is the weight of the
// neuron's reader. The phase is integrated, so the output stays continuous when the frequency is
// itself a signal.

#include "brain/functions/families.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Hz; higher frequencies would shake joints rather than move them.
constexpr double kMaxFrequency = 4.0;

// A phase seldom passes 1, and a program for every x86-64 processor has to call a function for
// std::floor().
double fraction(double x) {
    if (x >= 0.0 && x < 1.0) return x;
    return x - std::floor(x);
}

// Advances the stored phase; returns the phase plus b, in cycles.
double advance_phase(const double* in, double* memory, double dt) {
    const double frequency = std::min(std::fabs(in[0]), kMaxFrequency);
    memory[0] = fraction(memory[0] + frequency * dt);
    return memory[0] + in[1];
}

double wave(const double* in, double* memory, double dt) {
    return sine(2.0 * kPi * advance_phase(in, memory, dt));
}

double saw(const double* in, double* memory, double dt) {
    return 2.0 * fraction(advance_phase(in, memory, dt)) - 1.0;
}

}  // namespace

void add_oscillators(NeuronFunctionRegistry& functions) {
    const std::vector<NeuronFunctionKind::InputHint> hints = {{0.8, 0.3, 2.0}, {0.8, -0.5, 0.5}};
    functions.add({.id = "oscillate-wave",
                   .label = "Wave",
                   .arity = 2,
                   .memory_size = 1,
                   .evaluate = wave,
                   .input_hints = hints,
                   .oscillates = true});
    functions.add({.id = "oscillate-saw",
                   .label = "Saw",
                   .arity = 2,
                   .memory_size = 1,
                   .evaluate = saw,
                   .input_hints = hints,
                   .oscillates = true});
}

}  // namespace cambrian
