#pragma once

// The genes: plain structs with the fields, ranges and defaults of genome/README.md 1. Angles in
// radians, lengths in metres.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

// Ranges of the genes' fields; ends included unless noted.
namespace gene_range {
inline constexpr std::size_t kMaxNodes = 16;
inline constexpr std::size_t kMaxBrainNeurons = 16;
inline constexpr std::size_t kMaxNodeNeurons = 8;
inline constexpr std::size_t kMaxEdges = 6;
inline constexpr std::size_t kMaxOrgans = 3;
inline constexpr std::size_t kMaxOrganParameters = 2;
inline constexpr std::size_t kMaxName = 64;  // bytes
inline constexpr int kMaxArity = 3;
inline constexpr int kMaxRecursion = 6;
inline constexpr int kMaxReference = 15;  // k, e, n, i
inline constexpr double kMinSize = 0.08;
inline constexpr double kMaxLength = 1.6;
inline constexpr double kMaxWidth = 0.96;  // and depth
inline constexpr double kMinLimit = 0.05;
inline constexpr double kMaxLimit = 2.6;
inline constexpr double kMaxWeight = 4.0;
inline constexpr double kMaxEdgeAngle = 1.4;
inline constexpr double kMinScale = 0.4;
inline constexpr double kMaxScale = 1.5;
}  // namespace gene_range

enum class SourceKind : std::uint8_t {
    kConstant,
    kLocalNeuron,
    kLocalSensor,
    kParentNeuron,
    kParentSensor,
    kChildNeuron,
    kChildSensor,
    kBrainNeuron,
    kPartNeuron,
    kPartSensor,
};

// The source of a value (genome/README.md 2). The kind determines which fields are used: `index` is
// a neuron k or a channel, `child` the e-th expressed child, `node` and `instance` name a part.
// Numbers are reduced modulo what is available, so a reference can be useless but never invalid.
struct SourceRef {
    SourceKind kind = SourceKind::kConstant;
    std::uint8_t index = 0;     // k or channel
    std::uint8_t child = 0;     // e
    std::uint8_t node = 0;      // n
    std::uint8_t instance = 0;  // i

    friend bool operator==(const SourceRef&, const SourceRef&) = default;
};

struct InputGene {
    SourceRef source;
    double weight = 1.0;  // [-4, 4]; for a constant, its value

    friend bool operator==(const InputGene&, const InputGene&) = default;
};

struct NeuronGene {
    std::uint8_t function = 0;      // index into KindCatalog::functions
    std::vector<InputGene> inputs;  // exactly the function's arity

    friend bool operator==(const NeuronGene&, const NeuronGene&) = default;
};

// Something that a part does besides moving its joint, such as a call. Its kind has the number and
// the rules of the parameters.
struct OrganGene {
    std::uint8_t kind = 0;  // index into KindCatalog::organs
    InputGene input = {};   // the signal that it follows
    // Those that the kind does not use are 0.
    std::array<double, gene_range::kMaxOrganParameters> parameters = {};

    friend bool operator==(const OrganGene&, const OrganGene&) = default;
};

struct EdgeGene {
    std::uint8_t target = 0;     // node index
    double position = 0.0;       // [0, 1) along the parent's outline
    double angle = 0.0;          // [-1.4, 1.4] from the outward normal
    double scale = 1.0;          // [0.4, 1.5]; multiplies the child's subtree
    bool reflect = false;        // flips handedness of the child's subtree
    bool terminal_only = false;  // edge is followed only where recursion has ended
    // The following are genes of space only (genome/README.md 6).
    double height = 0.0;         // [-1, 1] between the parent's back and front
    double tilt = 0.0;           // [-1.4, 1.4] about the child's y axis
    double roll = 0.0;           // [-pi, pi) about the child's long axis
    bool reflect_depth = false;  // exchanges front and back of the child's subtree

    friend bool operator==(const EdgeGene&, const EdgeGene&) = default;
};

enum class MirrorAxis : std::uint8_t { kAlong, kAcross, kDepth };  // the last one in space only

// A degree of freedom of a joint in space besides the first.
struct DegreeGene {
    double limit_low = -1.0;  // [-2.6, -0.05]
    double limit_high = 1.0;  // [0.05, 2.6]
    InputGene effector = {.source = {}, .weight = 0.0};

    friend bool operator==(const DegreeGene&, const DegreeGene&) = default;
};

struct NodeGene {
    double length = 0.5;      // [0.08, 1.6]
    double width = 0.2;       // [0.08, 0.96]
    std::uint8_t joint = 1;   // index into KindCatalog::joints; ignored on the root
    double limit_low = -1.0;  // [-2.6, -0.05]
    double limit_high = 1.0;  // [0.05, 2.6]
    int recursion_limit = 1;  // 1 to 6
    bool symmetric = false;   // several edges from one parent become mirror pairs
    MirrorAxis mirror_axis = MirrorAxis::kAlong;
    std::uint8_t effector_kind = 0;  // index into KindCatalog::effectors
    InputGene effector;              // its source drives this part's joint
    std::vector<OrganGene> organs;   // 0 to 3
    std::vector<NeuronGene> neurons;
    std::vector<EdgeGene> edges;
    double depth = 0.2;               // [0.08, 0.96]; of space only
    std::vector<DegreeGene> further;  // as many as the joint has degrees of freedom but one
    std::uint32_t uid = 0;            // kept in copies; used only for display and alignment

    // uid is not compared: it has no effect on the phenotype.
    friend bool operator==(const NodeGene& a, const NodeGene& b);
};

// Returns what drives a degree of freedom of a node's joint.
inline InputGene& effector_of(NodeGene& node, std::size_t degree) {
    return degree == 0 ? node.effector : node.further[degree - 1].effector;
}
inline const InputGene& effector_of(const NodeGene& node, std::size_t degree) {
    return degree == 0 ? node.effector : node.further[degree - 1].effector;
}

}  // namespace cambrian
