#pragma once

#include "brain/network.h"

#include <cstddef>
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
    double output(std::size_t index) const;
    // Present value of any slot.
    double value(Slot slot) const { return values_[slot]; }
    std::span<const double> values() const { return values_; }
    std::span<const double> memory() const { return memory_; }
    // Whatever a neuron computes, it says this value until released.
    void force(std::size_t neuron, double value);
    void release(std::size_t neuron);
    void release_all() { forced_.clear(); }

private:
    void overwrite(std::size_t neuron);

    const Network* network_;
    std::vector<NeuronFunctionKind::Evaluate> evaluate_;  // one a neuron
    std::vector<double> values_;
    std::vector<double> memory_;
    std::vector<std::pair<std::size_t, double>> forced_;
};

}  // namespace cambrian
