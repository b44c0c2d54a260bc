#pragma once

// Registers the families of neuron functions (brain/README.md 2). In their formulas a, b and c are
// the inputs.

#include "brain/neuron_function.h"

namespace cambrian {

void add_arithmetic_functions(NeuronFunctionRegistry& functions);
void add_logic_functions(NeuronFunctionRegistry& functions);
void add_analytic_functions(NeuronFunctionRegistry& functions);
void add_temporal_functions(NeuronFunctionRegistry& functions);
void add_oscillators(NeuronFunctionRegistry& functions);

}  // namespace cambrian
