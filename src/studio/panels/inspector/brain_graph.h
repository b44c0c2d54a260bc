#pragma once

// The compiled network as a graph to draw: sensors in use, neurons, effectors and organs.

#include "creature/phenotype.h"
#include "studio/widgets/graph_layout.h"

#include <string>
#include <vector>

namespace cambrian {

enum class BrainNodeKind : unsigned char { kSensor, kNeuron, kEffector };

struct BrainNode {
    BrainNodeKind kind = BrainNodeKind::kNeuron;
    std::string label;  // "Sine", "Joint angle", "Joint"
    int part = -1;      // part that it belongs to; -1 for central neurons
    std::size_t index =
        0;  // value slot of a sensor or neuron, output index of an effector or organ
    GraphPoint place;
};

struct BrainLink {
    GraphEdge edge;  // indices into BrainGraph::nodes
    double weight = 0.0;
};

struct BrainGraph {
    std::vector<BrainNode> nodes;  // sensors, neurons in order of evaluation, effectors, organs
    std::vector<BrainLink> links;
    std::size_t row_count = 1;
};

// Returns the graph; no row has more than `most` nodes.
BrainGraph brain_graph(const Phenotype& phenotype, const Kinds& kinds, std::size_t most);

}  // namespace cambrian
