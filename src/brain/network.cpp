// Neurons are in the order of lazy evaluation, computed once (brain/README.md 3). In lazy
// evaluation a neuron first evaluates its inputs in order and then itself; when asked again, it
// returns its present value. This walk is the same in every tick. An input that is complete before
// its reader is earlier in the order and has this tick's value. An input that is still in progress
// (a cycle) is later in the order and has the last tick's value, as lazy evaluation requires.

#include "brain/network.h"

namespace cambrian {
namespace {

class Walk {
public:
    explicit Walk(const Network& network) : network_(network), asked_(network.neurons.size()) {}

    void ask(Slot slot) {
        enter(slot);
        while (!pending_.empty())
            advance();
    }
    std::vector<std::uint32_t> take_order() { return std::move(order_); }

private:
    struct Visit {
        std::size_t neuron;
        std::size_t next_input;
    };

    // Makes one step of a depth-first walk. Its stack is on the heap, so that large networks cannot
    // exhaust the thread's.
    void advance() {
        Visit& visit = pending_.back();
        const NetworkNeuron& neuron = network_.neurons[visit.neuron];
        if (visit.next_input < neuron.arity) {
            enter(neuron.inputs[visit.next_input++].slot);
            return;
        }
        order_.push_back(static_cast<std::uint32_t>(visit.neuron));
        pending_.pop_back();
    }

    void enter(Slot slot) {
        if (slot < network_.neuron_slot(0)) return;
        const std::size_t neuron = slot - network_.neuron_slot(0);
        CAMBRIAN_ASSERT(neuron < asked_.size(), "an input names an existing slot");
        if (asked_[neuron]) return;
        asked_[neuron] = true;
        pending_.push_back({neuron, 0});
    }

    const Network& network_;
    std::vector<bool> asked_;
    std::vector<Visit> pending_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

void compile(Network& network, const NeuronFunctionRegistry& functions) {
    Walk walk(network);
    for (const NetworkInput& output : network.outputs)
        walk.ask(output.slot);
    network.order = walk.take_order();
    network.memory_size = 0;
    for (NetworkNeuron& neuron : network.neurons) {
        neuron.memory = static_cast<std::uint32_t>(network.memory_size);
        network.memory_size += static_cast<std::size_t>(functions[neuron.function].memory_size);
    }
}

}  // namespace cambrian
