#pragma once

// A planar genome with the body it grows into and the gene that placed each part
// (sketch/README.md 1).

#include "creature/phenotype.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

// What a drawn body is grown with; all must outlive it.
struct SketchRules {
    const Kinds& kinds;
    const ExpressionSettings& expression;
    const SceneSettings& scene;
};

// The edge that placed a part, of the list of its parent's node.
struct PartOrigin {
    std::size_t edge = 0;                     // the first one of a mirror pair
    std::optional<std::size_t> partner = {};  // the second one
    std::optional<MirrorAxis> image_by = {};  // set if the part is the pair's mirror image
    double scale = 1.0;                       // of sizes, multiplied along the path from the root
};

struct BodySketch {
    Genome genome;
    Phenotype body;
    std::vector<PartOrigin> origins;  // one per part; that of the root has only a scale

    const NodeGene& node_of(std::size_t part) const { return genome.nodes[body.parts[part].node]; }
    // The following need a part other than the root.
    std::size_t parent_of(std::size_t part) const {
        return static_cast<std::size_t>(body.parts[part].parent);
    }
    const EdgeGene& edge_of(std::size_t part) const {
        return node_of(parent_of(part)).edges[origins[part].edge];
    }
};

BodySketch sketch_of(Genome genome, const SketchRules& rules);

// Names a part by what stays the same while other genes are edited. Copies of a node may share its
// uid; then the index tells them apart as long as it is the same.
struct PartName {
    std::uint32_t uid = 0;  // of its node
    std::uint8_t instance = 0;
    std::uint8_t node = 0;

    friend bool operator==(const PartName&, const PartName&) = default;
};
PartName name_of(const BodySketch& sketch, std::size_t part);
std::optional<std::size_t> find_part(const BodySketch& sketch, const PartName& name);

// Places of a part in the world, m.
Vec2 joint_place(const BodySketch& sketch, std::size_t part);
Vec2 in_world(const PlannedPart& part, const Vec2& inside);
Vec2 into_part(const PlannedPart& part, const Vec2& world);

}  // namespace cambrian
