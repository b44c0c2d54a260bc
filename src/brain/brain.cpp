#include "brain/brain.h"

#include <algorithm>

namespace cambrian {

Brain::Brain(const Network& network, const NeuronFunctionRegistry& functions)
    : network_(&network), values_(network.slot_count()), memory_(network.memory_size) {
    live_.reserve(network.order.size());
    for (const std::uint32_t index : network.order) {
        const NetworkNeuron& neuron = network.neurons[index];
        LiveNeuron& live = live_.emplace_back();
        live.evaluate = functions[neuron.function].evaluate;
        live.output = network.neuron_slot(index);
        live.memory = neuron.memory;
        live.has_third_input = neuron.arity == 3;
        for (std::size_t i = 0; i < neuron.arity; ++i) {
            live.inputs[i] = neuron.inputs[i].slot;
            live.weights[i] = neuron.inputs[i].weight;
        }
    }
    reset();
}

bool Brain::go_on_from(std::span<const double> values, std::span<const double> memory) {
    if (values.size() != values_.size() || memory.size() != memory_.size()) return false;
    std::copy(values.begin(), values.end(), values_.begin());
    std::copy(memory.begin(), memory.end(), memory_.begin());
    return true;
}

void Brain::reset() {
    std::fill(values_.begin(), values_.end(), 0.0);
    std::fill(memory_.begin(), memory_.end(), 0.0);
    values_[network_->constant_slot()] = 1.0;
}

// Weighs the first two inputs together. A neuron with one input ignores the second.
void Brain::think(double dt) {
    double* const values = values_.data();
    double* const memory = memory_.data();
    const bool overwrites = !forced_.empty();
    std::array<double, 3> inputs{};
    for (const LiveNeuron& neuron : live_) {
        const SignalPair pair =
            limit_signals(SignalPair{neuron.weights[0], neuron.weights[1]} *
                          SignalPair{values[neuron.inputs[0]], values[neuron.inputs[1]]});
        inputs[0] = pair[0];
        inputs[1] = pair[1];
        if (neuron.has_third_input)
            inputs[2] = limit_signal(neuron.weights[2] * values[neuron.inputs[2]]);
        const double result = neuron.evaluate(inputs.data(), memory + neuron.memory, dt);
        values[neuron.output] = limit_signal(result);
        if (overwrites) overwrite(neuron.output);
    }
}

void Brain::overwrite(Slot slot) {
    for (const auto& [forced, value] : forced_) {
        if (network_->neuron_slot(forced) == slot) values_[slot] = value;
    }
}

void Brain::force(std::size_t neuron, double value) {
    CAMBRIAN_ASSERT(neuron < network_->neurons.size(), "a neuron of the network");
    release(neuron);
    forced_.emplace_back(neuron, limit_signal(value));
}

void Brain::release(std::size_t neuron) {
    std::erase_if(forced_, [&](const auto& forced) { return forced.first == neuron; });
}

}  // namespace cambrian
