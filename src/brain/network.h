#pragma once

// A compiled network: neurons in a fixed order of evaluation and one array of values
// (brain/README.md 3). It is immutable; a Brain adds values and memory.
//
// Value slots: [0, sensor_count) sensor readings, then the constant 1, then the constant 0, then
// one slot a neuron.

#include "brain/neuron_function.h"
#include "brain/signal.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

using Slot = std::uint32_t;

struct NetworkInput {
    Slot slot = 0;
    double weight = 0.0;
};

struct NetworkNeuron {
    std::uint8_t function = 0;  // index into the registry
    std::uint8_t arity = 1;
    std::array<NetworkInput, 3> inputs;
    std::uint32_t memory = 0;  // index of its first memory value
};

struct Network {
    std::size_t sensor_count = 0;
    std::vector<NetworkNeuron> neurons;  // neuron i writes neuron_slot(i)
    std::vector<NetworkInput> outputs;   // of effectors, then of organs, in the order of parts
    std::vector<std::uint32_t> order;    // connected neurons, in order of evaluation
    std::size_t memory_size = 0;

    Slot constant_slot() const { return static_cast<Slot>(sensor_count); }
    Slot zero_slot() const { return static_cast<Slot>(sensor_count + 1); }
    Slot neuron_slot(std::size_t neuron) const {
        return static_cast<Slot>(sensor_count + 2 + neuron);
    }
    std::size_t slot_count() const { return sensor_count + 2 + neurons.size(); }
};

// Computes `order` (depth-first post-order from the outputs) and the memory layout.
void compile(Network& network, const NeuronFunctionRegistry& functions);

}  // namespace cambrian
