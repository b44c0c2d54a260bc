#pragma once

#include "brain/network.h"
#include "core/assert.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cambrian {

// A network with its values and memory; think() allocates nothing. Keeps references to the network
// and the functions, which must outlive it.
class Brain {
public:
    Brain(const Network& network, const NeuronFunctionRegistry& functions);

    void reset();
    // The sensors' readings, to be filled before think().
    std::span<double> sensors() { return {values_.data(), network_->sensor_count}; }
    void think(double dt);
    // Weighted, limited value of one output after think().
    double output(std::size_t index) const {
        CAMBRIAN_TICK_ASSERT(index < network_->outputs.size(), "an output of the network");
        const NetworkInput& output = network_->outputs[index];
        return limit_signal(output.weight * values_[output.slot]);
    }
    // Present value of any slot.
    double value(Slot slot) const { return values_[slot]; }
    std::span<const double> values() const { return values_; }
    std::span<const double> memory() const { return memory_; }
    // Whatever a neuron computes, it says this value until released.
    void force(std::size_t neuron, double value);
    void release(std::size_t neuron);
    void release_all() { forced_.clear(); }

private:
    // What think() does for one live neuron.
    struct Step {
        NeuronFunctionKind::Evaluate evaluate = nullptr;
        std::array<NetworkInput, 3> inputs;
        std::uint32_t neuron = 0;
        std::uint32_t memory = 0;  // first of its memory values
        Slot slot = 0;             // which it writes
        std::uint8_t arity = 1;
    };

    static std::vector<Step> steps_of(const Network& network,
                                      const NeuronFunctionRegistry& functions);
    void overwrite(std::size_t neuron);

    const Network* network_;
    std::shared_ptr<const std::vector<Step>> steps_;  // in the network's order
    std::vector<double> values_;
    std::vector<double> memory_;
    std::vector<std::pair<std::size_t, double>> forced_;
};

}  // namespace cambrian
