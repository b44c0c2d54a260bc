#include "studio/panels/inspector/brain_graph.h"

#include <algorithm>
#include <map>
#include <optional>

namespace cambrian {
namespace {

// Returns the part that owns a neuron; -1 if the neuron is central.
int part_of_neuron(const Phenotype& phenotype, std::uint32_t neuron) {
    for (std::size_t i = 0; i < phenotype.parts.size(); ++i) {
        const BodyPart& part = phenotype.parts[i];
        const bool inside =
            neuron >= part.first_neuron && neuron < part.first_neuron + part.neuron_count;
        if (inside) return static_cast<int>(i);
    }
    return -1;
}

class Builder {
public:
    Builder(const Phenotype& phenotype, const Kinds& kinds) : body_(phenotype), kinds_(kinds) {}

    BrainGraph build(std::size_t most) {
        add_sensors();
        add_neurons();
        add_effectors();
        link_all();
        place(most);
        return std::move(graph_);
    }

private:
    void add_sensors() {
        for (std::size_t slot = 0; slot < body_.sensors.size(); ++slot) {
            const WiredSensor& sensor = body_.sensors[slot];
            const std::string& label = kinds_.sensors[sensor.kind].channels[sensor.channel].label;
            add({BrainNodeKind::kSensor, label, sensor.part, slot, {}}, static_cast<Slot>(slot));
        }
    }
    void add_neurons() {
        for (const std::uint32_t neuron : body_.network.order) {
            const std::string& label =
                kinds_.functions[body_.network.neurons[neuron].function].label;
            const Slot slot = body_.network.neuron_slot(neuron);
            add({BrainNodeKind::kNeuron, label, part_of_neuron(body_, neuron), slot, {}}, slot);
        }
    }
    void add_effectors() {
        first_effector_ = graph_.nodes.size();
        for (std::size_t i = 0; i < body_.effectors.size(); ++i) {
            graph_.nodes.push_back(
                {BrainNodeKind::kEffector, "Joint", body_.effectors[i].part, i, {}});
        }
        for (const GrownOrgan& organ : body_.organs) {
            const std::size_t output = graph_.nodes.size() - first_effector_;
            graph_.nodes.push_back({BrainNodeKind::kEffector,
                                    kinds_.organs[organ.kind].label,
                                    organ.part,
                                    output,
                                    {}});
        }
    }
    void add(BrainNode node, Slot slot) {
        node_of_[slot] = graph_.nodes.size();
        graph_.nodes.push_back(std::move(node));
    }

    void link(const NetworkInput& input, std::size_t to) {
        const auto from = node_of_.find(input.slot);
        if (from != node_of_.end()) graph_.links.push_back({{from->second, to}, input.weight});
    }
    void link_all() {
        for (const std::uint32_t index : body_.network.order) {
            const NetworkNeuron& neuron = body_.network.neurons[index];
            for (std::size_t i = 0; i < neuron.arity; ++i)
                link(neuron.inputs[i], node_of_.at(body_.network.neuron_slot(index)));
        }
        for (std::size_t i = 0; i < body_.network.outputs.size(); ++i)
            link(body_.network.outputs[i], first_effector_ + i);
    }
    // Places sensors at the top, neurons below their inputs, effectors in the last row.
    void place(std::size_t most) {
        std::vector<GraphEdge> edges;
        for (const BrainLink& each : graph_.links)
            edges.push_back(each.edge);
        std::vector<std::size_t> rows = graph_rows(graph_.nodes.size(), edges);
        std::size_t last = 1;
        for (std::size_t i = 0; i < first_effector_; ++i) {
            if (graph_.nodes[i].kind == BrainNodeKind::kNeuron)
                rows[i] = std::max<std::size_t>(rows[i], 1);
            last = std::max(last, rows[i] + 1);
        }
        for (std::size_t i = first_effector_; i < graph_.nodes.size(); ++i)
            rows[i] = last;
        const std::vector<GraphPoint> points = place_in_rows(rows, edges, most);
        std::vector<float> levels;
        for (std::size_t i = 0; i < points.size(); ++i) {
            graph_.nodes[i].place = points[i];
            levels.push_back(points[i].y);
        }
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        graph_.row_count = std::max<std::size_t>(levels.size(), 1);
    }

    const Phenotype& body_;
    const Kinds& kinds_;
    BrainGraph graph_;
    std::map<Slot, std::size_t> node_of_;
    std::size_t first_effector_ = 0;
};

}  // namespace

BrainGraph brain_graph(const Phenotype& phenotype, const Kinds& kinds, std::size_t most) {
    return Builder(phenotype, kinds).build(most);
}

}  // namespace cambrian
