#include "creature/wiring.h"

#include "core/assert.h"
#include "creature/morphogenesis.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::size_t kBrain = static_cast<std::size_t>(-1);    // the reader is the central brain
constexpr std::size_t kNowhere = static_cast<std::size_t>(-2);  // the part does not exist

// While references are resolved, every channel of every part has a sensor slot. Slots that are not
// read are removed at the end.
class Wiring {
public:
    Wiring(const Genome& genome, const Kinds& kinds, Phenotype& phenotype)
        : genome_(genome),
          kinds_(kinds),
          phenotype_(phenotype),
          network_(phenotype.network),
          channel_count_(kinds.catalog.channels.size()),
          children_(phenotype.parts.size()),
          instances_(genome.nodes.size()) {}

    void run() {
        index_parts();
        add_neurons();
        add_effectors();
        add_organs();
        compile(network_, kinds_.functions);
        keep_heard_sensors();
        CAMBRIAN_TICK_ASSERT(
            network_.outputs.size() == phenotype_.effectors.size() + phenotype_.organs.size(),
            "an output an effector and an organ");
        CAMBRIAN_TICK_ASSERT(network_.sensor_count == phenotype_.sensors.size(), "a slot a sensor");
        phenotype_.has_live_control = hears_more_than_constants();
    }

private:
    const NodeGene& gene(std::size_t part) const {
        return genome_.nodes[phenotype_.parts[part].node];
    }

    void index_parts() {
        std::uint32_t neurons = 0;
        for (std::size_t i = 0; i < phenotype_.parts.size(); ++i) {
            BodyPart& part = phenotype_.parts[i];
            part.first_neuron = neurons;
            part.neuron_count = static_cast<std::uint32_t>(gene(i).neurons.size());
            neurons += part.neuron_count;
            instances_[part.node].push_back(i);
            if (part.parent >= 0) children_[static_cast<std::size_t>(part.parent)].push_back(i);
        }
        phenotype_.first_brain_neuron = neurons;
        network_.sensor_count = phenotype_.parts.size() * channel_count_;
    }

    void add_neurons() {
        for (std::size_t part = 0; part < phenotype_.parts.size(); ++part) {
            for (const NeuronGene& neuron : gene(part).neurons)
                add_neuron(neuron, part);
        }
        for (const NeuronGene& neuron : genome_.brain)
            add_neuron(neuron, kBrain);
    }

    void add_neuron(const NeuronGene& neuron, std::size_t reader) {
        NetworkNeuron added;
        added.function = neuron.function;
        added.arity = static_cast<std::uint8_t>(neuron.inputs.size());
        for (std::size_t i = 0; i < neuron.inputs.size(); ++i) {
            added.inputs[i] = {resolve(neuron.inputs[i].source, reader), neuron.inputs[i].weight};
        }
        CAMBRIAN_TICK_ASSERT(added.arity <= added.inputs.size(), "inputs have room");
        network_.neurons.push_back(added);
    }

    void add_effectors() {
        for (std::size_t i = 1; i < phenotype_.parts.size(); ++i) {
            const PlannedPart& body = phenotype_.plan.parts[i];
            if (body.motion == JointMotion::kFixed) continue;
            const BodyPart& part = phenotype_.parts[i];
            for (std::size_t degree = 0; degree < degrees_of(body); ++degree) {
                const double to_joint = body.motion == JointMotion::kSlide
                                            ? part.length
                                            : part.mirror.of_turn(body.axes[degree]);
                const InputGene& effector = effector_of(gene(i), degree);
                phenotype_.effectors.push_back(
                    {static_cast<std::uint16_t>(i), static_cast<std::uint8_t>(degree)});
                phenotype_.effector_kinds.push_back(gene(i).effector_kind);
                network_.outputs.push_back(
                    {resolve(effector.source, i), to_joint * effector.weight});
            }
        }
    }

    void add_organs() {
        for (std::size_t i = 0; i < phenotype_.parts.size(); ++i) {
            for (const OrganGene& organ : gene(i).organs) {
                const OrganKind& kind = kinds_.organs[organ.kind];
                const bool deforms =
                    kind.shape != nullptr && phenotype_.plan.parts[i].stretch.has_value();
                phenotype_.organs.push_back({static_cast<std::uint16_t>(i), organ.kind,
                                             organ.parameters, kind.place, kind.mark, deforms});
                network_.outputs.push_back({resolve(organ.input.source, i), organ.input.weight});
            }
        }
    }

    Slot resolve(const SourceRef& source, std::size_t reader) const {
        switch (source.kind) {
            case SourceKind::kConstant:
                return network_.constant_slot();
            case SourceKind::kLocalNeuron:
                return neuron_of(reader, source.index);
            case SourceKind::kLocalSensor:
                return sensor_of(reader, source.index);
            case SourceKind::kParentNeuron:
                return neuron_of(parent_of(reader), source.index);
            case SourceKind::kParentSensor:
                return sensor_of(parent_of(reader), source.index);
            case SourceKind::kChildNeuron:
                return neuron_of(nth(children_[reader], source.child), source.index);
            case SourceKind::kChildSensor:
                return sensor_of(nth(children_[reader], source.child), source.index);
            case SourceKind::kBrainNeuron:
                return brain_neuron(source.index);
            case SourceKind::kPartNeuron:
                return neuron_of(part_of(source), source.index);
            case SourceKind::kPartSensor:
                return sensor_of(part_of(source), source.index);
        }
        return network_.zero_slot();
    }

    static std::size_t nth(const std::vector<std::size_t>& parts, std::size_t number) {
        return parts.empty() ? kNowhere : parts[number % parts.size()];
    }
    std::size_t parent_of(std::size_t part) const {
        const int parent = phenotype_.parts[part].parent;
        return parent < 0 ? kNowhere : static_cast<std::size_t>(parent);
    }
    std::size_t part_of(const SourceRef& source) const {
        return nth(instances_[source.node % instances_.size()], source.instance);
    }

    Slot neuron_of(std::size_t part, std::size_t number) const {
        if (part == kNowhere || phenotype_.parts[part].neuron_count == 0) {
            return network_.zero_slot();
        }
        const BodyPart& owner = phenotype_.parts[part];
        return network_.neuron_slot(owner.first_neuron + number % owner.neuron_count);
    }
    Slot brain_neuron(std::size_t number) const {
        if (genome_.brain.empty()) return network_.zero_slot();
        return network_.neuron_slot(phenotype_.first_brain_neuron + number % genome_.brain.size());
    }
    Slot sensor_of(std::size_t part, std::size_t channel) const {
        if (part == kNowhere || channel >= channel_count_) return network_.zero_slot();
        return static_cast<Slot>(part * channel_count_ + channel);
    }

    std::vector<bool> heard_slots() const {
        std::vector<bool> heard(network_.slot_count(), false);
        for (const NetworkInput& output : network_.outputs)
            heard[output.slot] = true;
        for (const std::uint32_t index : network_.order) {
            const NetworkNeuron& neuron = network_.neurons[index];
            for (std::size_t i = 0; i < neuron.arity; ++i)
                heard[neuron.inputs[i].slot] = true;
        }
        return heard;
    }

    WiredSensor wired_sensor(std::size_t part, std::size_t channel) const {
        WiredSensor sensor;
        sensor.part = static_cast<std::uint16_t>(part);
        while (channel >= kinds_.sensors[sensor.kind].channels.size())
            channel -= kinds_.sensors[sensor.kind++].channels.size();
        sensor.channel = static_cast<std::uint8_t>(channel);
        sensor.mirror = phenotype_.parts[part].mirror;
        const bool sliding = part > 0 && phenotype_.plan.parts[part].motion == JointMotion::kSlide;
        if (sliding && kinds_.sensors[sensor.kind].reads_joint) {
            sensor.mirror.across = 1;
            sensor.scale = 1.0 / phenotype_.parts[part].length;
        }
        return sensor;
    }

    // Renumbers the slots so that only sensors read by a connected neuron or an effector have one.
    // References of disconnected neurons to other sensors become 0.
    void keep_heard_sensors() {
        const std::vector<bool> heard = heard_slots();
        const std::size_t old_count = network_.sensor_count;
        for (std::size_t slot = 0; slot < old_count; ++slot) {
            if (!heard[slot]) continue;
            const WiredSensor sensor = wired_sensor(slot / channel_count_, slot % channel_count_);
            phenotype_.plan.parts[sensor.part].measures_forces |=
                kinds_.sensors[sensor.kind].reads_forces;
            phenotype_.sees |= kinds_.sensors[sensor.kind].sees;
            phenotype_.sensors.push_back(sensor);
        }
        network_.sensor_count = phenotype_.sensors.size();
        std::vector<Slot> new_slot(heard.size(), network_.zero_slot());
        Slot next = 0;
        for (std::size_t slot = 0; slot < heard.size(); ++slot) {
            if (slot >= old_count || heard[slot]) new_slot[slot] = next++;
        }
        for (NetworkInput& output : network_.outputs)
            output.slot = new_slot[output.slot];
        for (NetworkNeuron& neuron : network_.neurons) {
            for (std::size_t i = 0; i < neuron.arity; ++i)
                neuron.inputs[i].slot = new_slot[neuron.inputs[i].slot];
        }
    }

    // A neuron is constant if it has no memory and everything it reads is constant. On a cycle it
    // is not constant, because it reads a neuron that comes later in the order.
    bool hears_more_than_constants() const {
        std::vector<bool> constant(network_.slot_count(), false);
        constant[network_.constant_slot()] = true;
        constant[network_.zero_slot()] = true;
        for (const std::uint32_t index : network_.order) {
            const NetworkNeuron& neuron = network_.neurons[index];
            bool all = kinds_.functions[neuron.function].memory_size == 0;
            for (std::size_t i = 0; i < neuron.arity; ++i)
                all = all && constant[neuron.inputs[i].slot];
            constant[network_.neuron_slot(index)] = all;
        }
        const std::size_t effectors = phenotype_.effectors.size();
        for (std::size_t i = 0; i < network_.outputs.size(); ++i) {
            const bool moves = i < effectors || phenotype_.organs[i - effectors].deforms;
            if (moves && !constant[network_.outputs[i].slot]) return true;
        }
        return false;
    }

    const Genome& genome_;
    const Kinds& kinds_;
    Phenotype& phenotype_;
    Network& network_;
    std::size_t channel_count_;
    std::vector<std::vector<std::size_t>> children_;   // of each part, in order of creation
    std::vector<std::vector<std::size_t>> instances_;  // of each node, in order of creation
};

}  // namespace

void wire(const Genome& genome, const Kinds& kinds, Phenotype& phenotype) {
    Wiring(genome, kinds, phenotype).run();
}

}  // namespace cambrian
