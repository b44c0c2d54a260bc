#pragma once

// The wired network as a graph to draw: used sensors, live neurons, effectors.

#include "creature/phenotype.h"
#include "studio/widgets/graph_layout.h"

#include <string>
#include <vector>

namespace cambrian {

enum class BrainNodeKind : unsigned char { kSensor, kNeuron, kEffector };

struct BrainNode {
    BrainNodeKind kind = BrainNodeKind::kNeuron;
    std::string label;      // "Sine", "Joint angle", "Joint"
    int part = -1;          // it sits on; -1 for central neurons
    std::size_t index = 0;  // value slot of sensors and neurons, output of effectors
    GraphPoint place;
};

struct BrainLink {
    GraphEdge edge;  // indices into the nodes
    double weight = 0.0;
};

struct BrainGraph {
    std::vector<BrainNode> nodes;  // sensors, neurons in the order they think, effectors
    std::vector<BrainLink> links;
    std::size_t row_count = 1;
};

// `most` nodes stand side by side at most.
BrainGraph brain_graph(const Phenotype& phenotype, const Kinds& kinds, std::size_t most);

}  // namespace cambrian
