#include "bench/sense_variants.h"

#include <algorithm>

namespace cambrian::bench {
namespace {

bool is_read(const SensorKind& kind, std::string_view senses) {
    return senses == "all" || (senses == "1994" && kind.usual);
}

// Gives the network's inputs other slots. `new_sensor` has the new slot of each sensor, or -1 if it
// was removed.
void renumber(Network& network, const std::vector<int>& new_sensor, std::size_t sensor_count) {
    const auto old_count = network.sensor_count;
    network.sensor_count = sensor_count;
    const auto move = [&](NetworkInput& input) {
        if (input.slot >= old_count) {
            input.slot += static_cast<Slot>(sensor_count - old_count);
        } else {
            const int slot = new_sensor[input.slot];
            input.slot = slot < 0 ? network.zero_slot() : static_cast<Slot>(slot);
        }
    };
    for (NetworkNeuron& neuron : network.neurons)
        std::for_each(neuron.inputs.begin(), neuron.inputs.begin() + neuron.arity, move);
    std::for_each(network.outputs.begin(), network.outputs.end(), move);
}

}  // namespace

Phenotype with_every_channel(Phenotype creature, const Kinds& kinds) {
    std::vector<int> slots;
    for (std::size_t i = 0; i < creature.sensors.size(); ++i)
        slots.push_back(static_cast<int>(i));
    std::size_t part = 0;
    for (std::size_t kind = 0; kind < kinds.sensors.size(); ++kind) {
        for (std::size_t channel = 0; channel < kinds.sensors[kind].channels.size(); ++channel) {
            part = (part + 1) % creature.parts.size();
            WiredSensor sensor;
            sensor.part = static_cast<std::uint16_t>(part);
            sensor.kind = static_cast<std::uint8_t>(kind);
            sensor.channel = static_cast<std::uint8_t>(channel);
            sensor.handedness = creature.parts[part].handedness;
            creature.sensors.push_back(sensor);
        }
    }
    renumber(creature.network, slots, creature.sensors.size());
    return creature;
}

Phenotype with_senses(Phenotype creature, const Kinds& kinds, std::string_view senses) {
    std::vector<WiredSensor> kept;
    std::vector<int> slots;
    for (PlannedPart& part : creature.plan.parts)
        part.measures_forces = false;
    for (const WiredSensor& sensor : creature.sensors) {
        const SensorKind& kind = kinds.sensors[sensor.kind];
        const bool keep = is_read(kind, senses);
        slots.push_back(keep ? static_cast<int>(kept.size()) : -1);
        if (!keep) continue;
        creature.plan.parts[sensor.part].measures_forces |= kind.reads_forces;
        kept.push_back(sensor);
    }
    creature.sensors = std::move(kept);
    renumber(creature.network, slots, creature.sensors.size());
    return creature;
}

}  // namespace cambrian::bench
