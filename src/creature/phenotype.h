#pragma once

// What a genotype grows into: parts (with the gene each came from), a body plan for physics and a
// compiled network. Immutable once expressed; shared by any number of trials.

#include "brain/network.h"
#include "creature/kinds.h"
#include "genome/genome.h"
#include "world/body_plan.h"
#include "world/scene_settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

struct ExpressionSettings {
    int max_parts = 16;  // 2 to 32
    int max_depth = 10;  // joints from the root
    int max_neurons = 256;
    bool strict_overlap = false;  // reject bodies whose parts overlap where no joint ties them

    friend bool operator==(const ExpressionSettings&, const ExpressionSettings&) = default;
};

struct BodyPart {
    std::uint8_t node = 0;      // gene it was expressed from
    std::uint8_t instance = 0;  // which copy of that node, in order of creation
    int parent = -1;
    int depth = 0;
    int handedness = 1;   // -1 on mirrored parts
    double length = 0.0;  // m, after scaling
    double width = 0.0;
    std::uint32_t first_neuron = 0;  // its neurons in the network
    std::uint32_t neuron_count = 0;
};

// A sensor channel some live neuron or effector reads; entry i fills network sensor slot i with
// scale times the reading.
struct WiredSensor {
    std::uint16_t part = 0;
    std::uint8_t kind = 0;     // index in the sensor registry
    std::uint8_t channel = 0;  // of that kind
    int handedness = 1;        // the part's, or +1 for a sliding joint, which no mirror turns round
    double scale = 1.0;        // 1 / length of the part for a sliding joint, else 1
};

struct Phenotype {
    std::vector<BodyPart> parts;
    BodyPlan plan;  // plan.parts[i] is parts[i]'s body
    std::vector<WiredSensor> sensors;
    // Output j drives the joint of part effector_parts[j]; its weight is the effector gene's,
    // turned round on mirrored parts and, for sliding joints, from lengths of the part into m.
    Network network;
    std::vector<std::uint16_t> effector_parts;  // parts whose joint moves, in part order
    std::vector<std::uint8_t> effector_kinds;   // index in the effector registry, one an effector
    std::uint32_t first_brain_neuron = 0;       // central neurons follow the parts' ones

    // Whether any joint can move, and whether any effector hears more than constants: without
    // either a creature scores 0 by definition (simulator/README.md 1).
    bool can_move() const { return !effector_parts.empty(); }
    bool has_live_control = false;

    double mass(double density) const;  // kg
    double rest_length() const;         // greatest corner-to-corner distance at rest, m
};

// Grows a valid genome (creature/README.md 1). Never fails; limits cut the body off evenly.
Phenotype express(const Genome& genome, const Kinds& kinds, const ExpressionSettings& settings,
                  const SceneSettings& scene);

}  // namespace cambrian
