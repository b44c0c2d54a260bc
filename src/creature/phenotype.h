#pragma once

// The phenotype that a genotype grows into: parts with the gene of each, a body plan for physics
// and a compiled network. It is immutable and can be shared by any number of trials.

#include "brain/network.h"
#include "creature/kinds.h"
#include "genome/genome.h"
#include "world/body_plan.h"
#include "world/scene_settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

struct ExpressionSettings {
    int max_parts = 16;  // 2 to 32
    int max_depth = 10;  // largest number of joints between a part and the root
    int max_neurons = 256;
    bool strict_overlap = false;  // reject bodies in which parts overlap that no joint connects

    friend bool operator==(const ExpressionSettings&, const ExpressionSettings&) = default;
};

struct BodyPart {
    std::uint8_t node = 0;      // index of the gene node it was expressed from
    std::uint8_t instance = 0;  // number of this copy of the node, in order of creation
    int parent = -1;
    int depth = 0;
    Mirror mirror = {};
    double length = 0.0;  // m, after scaling
    double width = 0.0;
    double thickness = 0.0;          // m, the size in depth; 0 in the plane
    std::uint32_t first_neuron = 0;  // index of its first neuron in the network
    std::uint32_t neuron_count = 0;
};

// A sensor channel that a connected neuron or an effector reads. Entry i sets the network's sensor
// slot i to `scale` times the reading.
struct WiredSensor {
    std::uint16_t part = 0;
    std::uint8_t kind = 0;     // index into the sensor registry
    std::uint8_t channel = 0;  // channel of that kind
    // Of the part; its handedness is 1 for a sliding joint, whose sign mirroring does not change.
    Mirror mirror = {};
    double scale = 1.0;  // 1 / length of the part for a sliding joint, otherwise 1
    // The constant that it reads whatever happens, in its own unit, to see what the creature loses
    // without it. No gene sets it.
    std::optional<double> held = {};
};

// An organ of a part.
struct GrownOrgan {
    std::uint16_t part = 0;
    std::uint8_t kind = 0;  // index into the organ registry
    std::array<double, gene_range::kMaxOrganParameters> parameters = {};
    // The place and the look of its mark (organs/organ.h).
    double place = 0.0;
    OrganMark mark = OrganMark::kDots;
    bool deforms = false;  // whether it makes its part deformable
};

// At most this many parts of a creature deform. Fewer do if physics has no room for more: each
// part and each deformable one again takes one of the places. Further deformers do nothing.
inline constexpr int kMostDeformers = 16;
inline constexpr int kPlacesOfParts = 32;

struct Phenotype {
    std::vector<BodyPart> parts;
    BodyPlan plan;  // plan.parts[i] is the body of parts[i]
    std::vector<WiredSensor> sensors;
    // Output j drives the degree of freedom effectors[j]. Its weight is that of the effector gene,
    // with the opposite sign where mirroring turns it. For sliding joints it also converts from
    // lengths of the part to m.
    Network network;
    std::vector<JointDegree> effectors;        // what moves of joints, in part order
    std::vector<std::uint8_t> effector_kinds;  // index into the effector registry, one per effector
    std::vector<GrownOrgan> organs;  // in part order; their outputs follow those of the effectors
    std::uint32_t first_brain_neuron = 0;  // central neurons follow those of the parts

    // Whether any joint or part can move, and whether any of their muscles reads more than
    // constants. Without either, the score is 0 by definition (simulator/README.md 1).
    bool can_move() const;
    std::size_t deformers() const;  // number of parts that deform
    bool has_live_control = false;
    bool sees = false;  // whether a sensor reads light

    double mass(double density) const;  // kg, with a density per area or, in space, volume
    double rest_length() const;         // m, greatest distance between two corners at rest
};

// Which of its two mirror images a creature grows into. They behave alike, left for right.
enum class Side : std::uint8_t { kGiven, kMirrored };

// Grows a valid genome (creature/README.md 1). Never fails; limits truncate the body evenly.
Phenotype express(const Genome& genome, const Kinds& kinds, const ExpressionSettings& settings,
                  const SceneSettings& scene, Side side = Side::kGiven);

}  // namespace cambrian
