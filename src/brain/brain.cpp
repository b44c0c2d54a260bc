#include "brain/brain.h"

#include <algorithm>

namespace cambrian {

Brain::Brain(const Network& network, const NeuronFunctionRegistry& functions)
    : network_(&network), values_(network.slot_count()), memory_(network.memory_size) {
    evaluate_.reserve(network.neurons.size());
    for (const NetworkNeuron& neuron : network.neurons)
        evaluate_.push_back(functions[neuron.function].evaluate);
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

void Brain::think(double dt) {
    double* const values = values_.data();
    double* const memory = memory_.data();
    double* const outputs = values + network_->neuron_slot(0);
    const NetworkNeuron* const neurons = network_->neurons.data();
    for (const std::uint32_t index : network_->order) {
        const NetworkNeuron& neuron = neurons[index];
        std::array<double, 3> inputs{};
        for (std::size_t i = 0; i < neuron.arity; ++i) {
            inputs[i] = limit_signal(neuron.inputs[i].weight * values[neuron.inputs[i].slot]);
        }
        const double result = evaluate_[index](inputs.data(), memory + neuron.memory, dt);
        outputs[index] = limit_signal(result);
        if (!forced_.empty()) overwrite(index);
    }
}

void Brain::overwrite(std::size_t neuron) {
    for (const auto& [forced, value] : forced_) {
        if (forced == neuron) values_[network_->neuron_slot(neuron)] = value;
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
