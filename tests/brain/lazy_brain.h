#pragma once

// The reference semantics of a brain (brain/README.md 3): neurons are evaluated on demand, once per
// tick. A neuron that is being evaluated answers with its value of the tick before.

#include "brain/network.h"

#include <algorithm>
#include <span>
#include <vector>

namespace cambrian {

class LazyBrain {
public:
    LazyBrain(const Network& network, const NeuronFunctionRegistry& functions)
        : network_(network),
          functions_(functions),
          values_(network.slot_count(), 0.0),
          memory_(network.memory_size, 0.0),
          stamps_(network.neurons.size(), 0),
          completed_(network.neurons.size(), 0) {
        values_[network.constant_slot()] = 1.0;
    }

    std::span<double> sensors() { return {values_.data(), network_.sensor_count}; }
    void think(double dt) {
        ++stamp_;
        for (const NetworkInput& output : network_.outputs)
            ask(output.slot, dt);
    }
    double output(std::size_t index) const {
        const NetworkInput& output = network_.outputs[index];
        return limit_signal(output.weight * values_[output.slot]);
    }
    // Number of reads of a neuron during its own evaluation.
    std::size_t cycle_reads() const { return cycle_reads_; }

private:
    double ask(Slot slot, double dt) {
        if (slot < network_.neuron_slot(0)) return values_[slot];
        const std::size_t index = slot - network_.neuron_slot(0);
        if (stamps_[index] == stamp_) {
            cycle_reads_ += completed_[index] != stamp_;
            return values_[slot];
        }
        stamps_[index] = stamp_;
        const NetworkNeuron& neuron = network_.neurons[index];
        std::array<double, 3> inputs{};
        for (std::size_t i = 0; i < neuron.arity; ++i)
            inputs[i] = limit_signal(neuron.inputs[i].weight * ask(neuron.inputs[i].slot, dt));
        const double result =
            functions_[neuron.function].evaluate(inputs.data(), memory_.data() + neuron.memory, dt);
        completed_[index] = stamp_;
        return values_[slot] = limit_signal(result);
    }

    const Network& network_;
    const NeuronFunctionRegistry& functions_;
    std::vector<double> values_;
    std::vector<double> memory_;
    std::vector<int> stamps_;
    std::vector<int> completed_;
    int stamp_ = 0;
    std::size_t cycle_reads_ = 0;
};

}  // namespace cambrian
