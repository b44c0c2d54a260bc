#include "creature/phenotype_hash.h"

#include "core/hash.h"

namespace cambrian {
namespace {

void add_integer(Hash64& hash, std::int64_t number) {
    hash.add(static_cast<std::uint64_t>(number));
}

void add_point(Hash64& hash, const Vec3& point) {
    for (const double coordinate : {point.x(), point.y(), point.z()})
        hash.add(coordinate);
}

void add_part(Hash64& hash, const PlannedPart& part) {
    add_point(hash, part.half_extents);
    add_point(hash, part.rest_pose.position);
    for (const double coefficient : part.rest_pose.orientation.coeffs())
        hash.add(coefficient);
    hash.add(part.rest_angle);
    add_integer(hash, part.parent);
    add_integer(hash, static_cast<std::uint8_t>(part.motion));
    add_point(hash, part.anchor_in_parent);
    add_point(hash, part.anchor_in_child);
    for (const double number : {part.limit_low, part.limit_high, part.max_effort})
        hash.add(number);
    add_integer(hash, static_cast<std::int64_t>(part.motor_mode));
    // Parts of the plane keep the hash that they had before there were others.
    if (part.half_extents.z() > 0.0) {
        for (std::size_t degree = 0; degree < degrees_of(part); ++degree) {
            add_integer(hash, part.axes[degree]);
            const DegreeLimits limits = limits_of(part, degree);
            for (const double number : {limits.low, limits.high, limits.max_effort})
                hash.add(number);
        }
    }
    if (!part.stretch) return;
    for (const double number : {part.stretch->low, part.stretch->high, part.stretch->max_effort,
                                part.stretch->rate_limit})
        hash.add(number);
}

void add_sensor(Hash64& hash, const WiredSensor& sensor) {
    for (const int number : {int{sensor.part}, int{sensor.kind}, int{sensor.channel}})
        add_integer(hash, number);
    add_integer(hash, sensor.mirror.across);
    hash.add(sensor.scale);
    if (sensor.mirror.depth != 1) add_integer(hash, sensor.mirror.depth);
}

// Adds connected neurons to the hash, numbered in the order of evaluation.
class NetworkReader {
public:
    NetworkReader(const Network& network, Hash64& hash)
        : network_(network), hash_(hash), slots_(network.slot_count()) {
        const std::size_t first = network.sensor_count + 2;
        for (std::size_t slot = 0; slot < first; ++slot)
            slots_[slot] = slot;
        for (std::size_t turn = 0; turn < network.order.size(); ++turn)
            slots_[network.neuron_slot(network.order[turn])] = first + turn;
    }

    void read() {
        for (const std::uint32_t index : network_.order) {
            const NetworkNeuron& neuron = network_.neurons[index];
            add_integer(hash_, neuron.function);
            for (std::size_t input = 0; input < neuron.arity; ++input)
                add(neuron.inputs[input]);
        }
        for (const NetworkInput& output : network_.outputs)
            add(output);
    }

private:
    void add(const NetworkInput& input) {
        hash_.add(std::uint64_t{slots_[input.slot]});
        hash_.add(input.weight);
    }

    const Network& network_;
    Hash64& hash_;
    std::vector<std::size_t> slots_;
};

}  // namespace

std::uint64_t phenotype_hash(const Phenotype& phenotype) {
    Hash64 hash;
    hash.add(std::uint64_t{phenotype.plan.parts.size()});
    for (const PlannedPart& part : phenotype.plan.parts)
        add_part(hash, part);
    hash.add(std::uint64_t{phenotype.sensors.size()});
    for (const WiredSensor& sensor : phenotype.sensors)
        add_sensor(hash, sensor);
    hash.add(std::uint64_t{phenotype.network.order.size()});
    NetworkReader(phenotype.network, hash).read();
    for (const JointDegree& effector : phenotype.effectors)
        add_integer(hash, effector.part);
    // The first kind adds nothing, so that hashes of creatures with it stay as in earlier versions.
    for (std::size_t i = 0; i < phenotype.effector_kinds.size(); ++i) {
        if (phenotype.effector_kinds[i] == 0) continue;
        add_integer(hash, static_cast<std::int64_t>(i));
        add_integer(hash, phenotype.effector_kinds[i]);
    }
    // Creatures without organs keep the hash that they had before there were any.
    for (const GrownOrgan& organ : phenotype.organs) {
        add_integer(hash, organ.part);
        add_integer(hash, organ.kind);
        for (const double parameter : organ.parameters)
            hash.add(parameter);
    }
    return hash.value();
}

}  // namespace cambrian
