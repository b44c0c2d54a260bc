#pragma once

#include "brain/network.h"
#include "core/assert.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// A network with its values and memory. think() allocates nothing. The network and the functions
// must outlive the brain.
class Brain {
public:
    Brain(const Network& network, const NeuronFunctionRegistry& functions);

    void reset();
    // The sensors' readings, which must be set before think().
    std::span<double> sensors() { return {values_.data(), network_->sensor_count}; }
    void think(double dt);
    // Returns the weighted, limited value of one output after think().
    double output(std::size_t index) const {
        CAMBRIAN_TICK_ASSERT(index < network_->outputs.size(), "an output of the network");
        const NetworkInput& output = network_->outputs[index];
        return limit_signal(output.weight * values_[output.slot]);
    }
    // Returns the present value of any slot.
    double value(Slot slot) const { return values_[slot]; }
    std::span<const double> values() const { return values_; }
    std::span<const double> memory() const { return memory_; }
    // Goes on from values and memory of a brain with the same network. Returns false, without an
    // effect, if there are more or fewer of them.
    bool go_on_from(std::span<const double> values, std::span<const double> memory);
    // Sets the value of a neuron, whatever it computes, until released.
    void force(std::size_t neuron, double value);
    void release(std::size_t neuron);
    void release_all() { forced_.clear(); }

private:
    // A connected neuron with all that think() needs of it.
    struct LiveNeuron {
        NeuronFunctionKind::Evaluate evaluate = nullptr;
        Slot output = 0;
        std::uint32_t memory = 0;  // index of its first memory value
        std::array<Slot, 3> inputs = {};
        bool has_third_input = false;
        std::array<double, 3> weights = {};
    };

    void overwrite(Slot slot);

    const Network* network_;
    std::vector<LiveNeuron> live_;  // in order of evaluation
    std::vector<double> values_;
    std::vector<double> memory_;
    std::vector<std::pair<std::size_t, double>> forced_;
};

}  // namespace cambrian
