#include "brain/functions/families.h"
#include "brain/neuron_function.h"

namespace cambrian {

NeuronFunctionRegistry builtin_neuron_functions() {
    NeuronFunctionRegistry functions;
    add_arithmetic_functions(functions);
    add_logic_functions(functions);
    add_analytic_functions(functions);
    add_temporal_functions(functions);
    add_oscillators(functions);
    return functions;
}

}  // namespace cambrian
