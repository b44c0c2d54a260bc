#include "brain/neuron_function.h"
#include "brain/signal.h"
#include "core/hash.h"
#include "golden/golden.h"

#include <array>

namespace cambrian::golden {
namespace {

constexpr std::array kInputs = {-10.0, -3.1, -1.0, -0.25, -1e-300, -0.0,
                                0.0,   1e-9, 0.4,  1.0,   2.7,     10.0};
constexpr double kTick = 1.0 / 60;  // s

// Evaluates all triples of inputs in turn with the same memory.
std::uint64_t digest_of(const NeuronFunctionKind& kind) {
    Hash64 hash;
    std::vector<double> memory(static_cast<std::size_t>(kind.memory_size), 0.0);
    for (const double first : kInputs) {
        for (const double second : kInputs) {
            for (const double third : kInputs) {
                const std::array inputs = {first, second, third};
                hash.add(limit_signal(kind.evaluate(inputs.data(), memory.data(), kTick)));
            }
        }
    }
    for (const double remembered : memory)
        hash.add(remembered);
    return hash.value();
}

}  // namespace

void add_neuron_digests(Digests& digests) {
    const NeuronFunctionRegistry functions = builtin_neuron_functions();
    for (const NeuronFunctionKind& kind : functions.all())
        digests.push_back({"neuron." + kind.id, digest_of(kind)});
}

}  // namespace cambrian::golden
