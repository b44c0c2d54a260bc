#include "simulator/rest_watch.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr int kRestTicks = 120;           // 2 s
constexpr double kSlowestMotion = 0.001;  // m/s
constexpr double kSlowestSpin = 0.001;    // rad/s
constexpr double kLeastChange = 1e-6;     // per tick, of targets and memory

bool body_rests(const PhysicsScene& scene) {
    for (std::size_t part = 0; part < scene.part_count(); ++part) {
        const Twist twist = scene.part_twist(part);
        if (twist.linear.squaredNorm() > kSlowestMotion * kSlowestMotion ||
            twist.angular.squaredNorm() > kSlowestSpin * kSlowestSpin)
            return false;
    }
    return true;
}

}  // namespace

RestWatch::RestWatch(const Network& network, const NeuronFunctionRegistry& functions)
    : before_(network.memory_size, 0.0) {
    for (const std::uint32_t live : network.order) {
        const NetworkNeuron& neuron = network.neurons[live];
        const NeuronFunctionKind& function = functions[neuron.function];
        for (int i = 0; i < function.memory_size; ++i) {
            remembered_.push_back({.index = neuron.memory + static_cast<std::size_t>(i),
                                   .least_change = function.oscillates ? 0.0 : kLeastChange});
        }
    }
}

bool RestWatch::memory_rests(std::span<const double> memory) const {
    return std::all_of(remembered_.begin(), remembered_.end(), [&](const Remembered& value) {
        const double change = std::fabs(memory[value.index] - before_[value.index]);
        return change < value.least_change || change == 0.0;
    });
}

// Motion mostly shows in the targets already, or in the first part.
bool RestWatch::watch(const PhysicsScene& scene, const Brain& brain) {
    const std::span<const double> memory = brain.memory();
    const bool rests =
        scene.largest_target_change() < kLeastChange && body_rests(scene) && memory_rests(memory);
    std::copy(memory.begin(), memory.end(), before_.begin());
    calm_ticks_ = rests ? calm_ticks_ + 1 : 0;
    return calm_ticks_ >= kRestTicks;
}

}  // namespace cambrian
