#pragma once

// A kind of neuron: a function of one to three weighted inputs and a little memory
// (brain/README.md 2). Pure numbers; no idea of bodies.

#include "core/registry.h"

#include <string>
#include <vector>

namespace cambrian {

struct NeuronFunctionKind {
    // inputs: `arity` values, each finite and within +-10; memory: `memory_size` values, all 0 at
    // birth, updated in place; dt in s. The caller limits the result.
    using Evaluate = double (*)(const double* inputs, double* memory, double dt);

    // A suggestion for founders: with the probability the input is a constant in [low, high].
    struct InputHint {
        double probability = 0.0;
        double low = 0.0;
        double high = 0.0;
    };

    std::string id;     // written to files
    std::string label;  // shown
    int arity = 1;
    int memory_size = 0;
    Evaluate evaluate = nullptr;
    std::vector<InputHint> input_hints = {};  // one an input, or empty
    // Its memory is a phase: however slowly it moves on, the output goes through all of its range.
    bool oscillates = false;
};

using NeuronFunctionRegistry = Registry<NeuronFunctionKind>;

NeuronFunctionRegistry builtin_neuron_functions();

}  // namespace cambrian
