#pragma once

#include "brain/brain.h"

#include <initializer_list>
#include <string_view>

namespace cambrian {

// A brain of one neuron whose inputs are sensors with given readings, evaluated tick by tick.
class SingleNeuron {
public:
    explicit SingleNeuron(std::string_view function)
        : functions_(builtin_neuron_functions()),
          network_(make_network(functions_, function)),
          brain_(network_, functions_) {}
    SingleNeuron(const SingleNeuron&) = delete;
    SingleNeuron& operator=(const SingleNeuron&) = delete;

    double operator()(std::initializer_list<double> inputs, double dt = 1.0 / 60.0) {
        std::size_t i = 0;
        for (const double input : inputs)
            brain_.sensors()[i++] = input;
        brain_.think(dt);
        return brain_.output(0);
    }

private:
    static Network make_network(const NeuronFunctionRegistry& functions,
                                std::string_view function) {
        const std::size_t index = functions.index_of(function).value();
        Network network;
        network.sensor_count = 3;
        NetworkNeuron neuron;
        neuron.function = static_cast<std::uint8_t>(index);
        neuron.arity = static_cast<std::uint8_t>(functions[index].arity);
        for (Slot i = 0; i < 3; ++i)
            neuron.inputs[i] = {i, 1.0};
        network.neurons = {neuron};
        network.outputs = {{network.neuron_slot(0), 1.0}};
        compile(network, functions);
        return network;
    }

    NeuronFunctionRegistry functions_;
    Network network_;
    Brain brain_;
};

}  // namespace cambrian
