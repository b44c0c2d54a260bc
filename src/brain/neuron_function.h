#pragma once

// A kind of neuron: a function of one to three weighted inputs and some memory (brain/README.md 2).
// It does not depend on bodies.

#include "core/registry.h"

#include <string>
#include <vector>

namespace cambrian {

struct NeuronFunctionKind {
    // `inputs` has `arity` values, each finite and within +-10. `memory` has `memory_size` values,
    // which are 0 at birth and updated in place. `dt` is in s. The caller limits the result.
    using Evaluate = double (*)(const double* inputs, double* memory, double dt);

    // A suggestion for founders: with this probability the input is a constant in [low, high].
    struct InputHint {
        double probability = 0.0;
        double low = 0.0;
        double high = 0.0;
    };

    std::string id;     // written to files
    std::string label;  // displayed name
    int arity = 1;
    int memory_size = 0;
    Evaluate evaluate = nullptr;
    std::vector<InputHint> input_hints = {};  // one per input, or empty
    // Its memory is a phase, so that even a slow change eventually covers the full range of the
    // output.
    bool oscillates = false;
};

using NeuronFunctionRegistry = Registry<NeuronFunctionKind>;

NeuronFunctionRegistry builtin_neuron_functions();

}  // namespace cambrian
