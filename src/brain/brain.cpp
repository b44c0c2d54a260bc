#include "brain/brain.h"

#include <algorithm>

namespace cambrian {

Brain::Brain(const Network& network, const NeuronFunctionRegistry& functions)
    : network_(&network),
      steps_(std::make_shared<const std::vector<Step>>(steps_of(network, functions))),
      values_(network.slot_count()),
      memory_(network.memory_size) {
    reset();
}

std::vector<Brain::Step> Brain::steps_of(const Network& network,
                                         const NeuronFunctionRegistry& functions) {
    std::vector<Step> steps;
    steps.reserve(network.order.size());
    for (const std::uint32_t index : network.order) {
        const NetworkNeuron& neuron = network.neurons[index];
        steps.push_back({.evaluate = functions[neuron.function].evaluate,
                         .inputs = neuron.inputs,
                         .neuron = index,
                         .memory = neuron.memory,
                         .slot = network.neuron_slot(index),
                         .arity = neuron.arity});
    }
    return steps;
}

void Brain::reset() {
    std::fill(values_.begin(), values_.end(), 0.0);
    std::fill(memory_.begin(), memory_.end(), 0.0);
    values_[network_->constant_slot()] = 1.0;
}

void Brain::think(double dt) {
    for (const Step& step : *steps_) {
        std::array<double, 3> inputs{};
        for (std::size_t i = 0; i < step.arity; ++i)
            inputs[i] = limit_signal(step.inputs[i].weight * values_[step.inputs[i].slot]);
        const double result = step.evaluate(inputs.data(), memory_.data() + step.memory, dt);
        values_[step.slot] = limit_signal(result);
        if (!forced_.empty()) overwrite(step.neuron);
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
