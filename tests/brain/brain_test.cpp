#include "brain/brain.h"

#include "brain/lazy_brain.h"
#include "brain/single_neuron.h"
#include "core/random.h"
#include "support/catch.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace cambrian;

namespace {

const NeuronFunctionRegistry& functions() {
    static const NeuronFunctionRegistry all = builtin_neuron_functions();
    return all;
}

Network random_network(RandomStream& stream) {
    Network network;
    network.sensor_count = stream.below(6);
    network.neurons.resize(1 + stream.below(20));
    const auto random_input = [&]() -> NetworkInput {
        return {static_cast<Slot>(stream.below(network.slot_count())), stream.uniform(-2.0, 2.0)};
    };
    for (NetworkNeuron& neuron : network.neurons) {
        neuron.function = static_cast<std::uint8_t>(stream.below(functions().size()));
        neuron.arity = static_cast<std::uint8_t>(functions()[neuron.function].arity);
        for (NetworkInput& input : neuron.inputs)
            input = random_input();
    }
    for (std::size_t i = stream.below(5); i > 0; --i)
        network.outputs.push_back(random_input());
    compile(network, functions());
    return network;
}

// Returns a ring of sums, each of which reads the one before; the first also reads the constant.
Network ring(std::size_t size) {
    Network network;
    network.neurons.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
        NetworkNeuron& neuron = network.neurons[i];
        neuron.function = static_cast<std::uint8_t>(functions().index_of("sum").value());
        neuron.arity = 3;
        const Slot other = i == 0 ? network.constant_slot() : network.zero_slot();
        neuron.inputs = {{{network.neuron_slot((i + size - 1) % size), 1.0},
                          {other, 1.0},
                          {network.zero_slot(), 1.0}}};
    }
    network.outputs = {{network.neuron_slot(size - 1), 1.0}};
    compile(network, functions());
    return network;
}

}  // namespace

TEST_CASE("the compiled order gives the lazy evaluation's bits, cycles included",
          "[brain][network]") {
    RandomStream stream(stream_seed(7, 0, 0, Purpose::kTest));
    int with_cycles = 0;
    for (int i = 0; i < 1000; ++i) {
        const Network network = random_network(stream);
        Brain brain(network, functions());
        LazyBrain lazy(network, functions());
        for (int tick = 0; tick < 100; ++tick) {
            for (std::size_t s = 0; s < network.sensor_count; ++s)
                brain.sensors()[s] = lazy.sensors()[s] = stream.uniform(-2.0, 2.0);
            brain.think(1.0 / 60.0);
            lazy.think(1.0 / 60.0);
            for (std::size_t o = 0; o < network.outputs.size(); ++o)
                REQUIRE(brain.output(o) == lazy.output(o));
        }
        with_cycles += lazy.cycle_reads() > 0;
    }
    CHECK(with_cycles > 200);
}

TEST_CASE("a signal passes a chain of neurons in one tick and a ring once a tick",
          "[brain][network]") {
    const Network network = ring(5);
    Brain brain(network, functions());
    brain.think(1.0 / 60.0);
    CHECK(brain.output(0) == 1.0);
    brain.think(1.0 / 60.0);
    CHECK(brain.output(0) == 2.0);
}

TEST_CASE("neurons no output can hear are not in the order", "[brain][network]") {
    Network network = ring(3);
    network.neurons.push_back(network.neurons[0]);
    compile(network, functions());
    CHECK(network.order.size() == 3);
    network.outputs.clear();
    compile(network, functions());
    CHECK(network.order.empty());
}

TEST_CASE("a reset brain repeats its life", "[brain]") {
    RandomStream stream(stream_seed(8, 0, 0, Purpose::kTest));
    const Network network = random_network(stream);
    Brain brain(network, functions());
    std::vector<double> first;
    for (int life = 0; life < 2; ++life) {
        for (int tick = 0; tick < 50; ++tick)
            brain.think(1.0 / 60.0);
        const std::vector<double> values(brain.values().begin(), brain.values().end());
        if (life == 0) first = values;
        CHECK(values == first);
        brain.reset();
    }
}

TEST_CASE("what hears a forced neuron hears the forced value in the same tick", "[brain]") {
    const Network network = ring(3);
    Brain brain(network, functions());
    brain.force(0, 3.0);
    brain.think(1.0 / 60.0);
    CHECK(brain.output(0) == 3.0);
}

TEST_CASE("a forced neuron keeps its value until released", "[brain]") {
    const Network network = ring(2);
    Brain brain(network, functions());
    brain.force(1, 5.0);
    brain.force(1, 25.0);
    brain.think(1.0 / 60.0);
    CHECK(brain.output(0) == kSignalLimit);
    brain.force(1, -3.0);
    brain.think(1.0 / 60.0);
    CHECK(brain.output(0) == -3.0);
    brain.release(1);
    brain.think(1.0 / 60.0);
    CHECK(brain.output(0) == -2.0);
}

TEST_CASE("two signals are limited together as each alone", "[brain]") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double values[] = {0.0,   -0.0,      2.5,      -2.5,   kSignalLimit,
                             1e300, -infinity, infinity, -1e300, std::nan("")};
    for (const double first : values) {
        for (const double second : values) {
            const SignalPair limited = limit_signals(SignalPair{first, second});
            REQUIRE(std::bit_cast<std::uint64_t>(limited[0]) ==
                    std::bit_cast<std::uint64_t>(limit_signal(first)));
            REQUIRE(std::bit_cast<std::uint64_t>(limited[1]) ==
                    std::bit_cast<std::uint64_t>(limit_signal(second)));
        }
    }
}
