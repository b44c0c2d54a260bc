#include "sketch/part_edits.h"

#include "core/assert.h"
#include "sketch/outline.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr double kEndOfPart = 0.125;  // position of the middle of its far end

bool is_at_end(const EdgeGene& edge) {
    return edge.position < 0.25;
}

std::vector<EdgeGene>& edges_to(Genome& genome, const BodySketch& sketch, std::size_t part) {
    return genome.nodes[sketch.body.parts[sketch.parent_of(part)].node].edges;
}

void end_repetition(NodeGene& node, std::uint8_t index) {
    std::erase_if(node.edges, [index](const EdgeGene& edge) { return edge.target == index; });
    for (EdgeGene& edge : node.edges)
        edge.terminal_only = false;
    node.recursion_limit = 1;
}

// Returns how many parts of the node are on the path from the root to a part, itself included.
int occurrence(const BodySketch& sketch, std::size_t part) {
    int count = 0;
    for (int at = static_cast<int>(part); at >= 0;
         at = sketch.body.parts[static_cast<std::size_t>(at)].parent)
        count +=
            sketch.body.parts[static_cast<std::size_t>(at)].node == sketch.body.parts[part].node;
    return count;
}

// Leaves the part alone where it is, whichever of the two it was.
Genome unpaired(const BodySketch& sketch, std::size_t part) {
    Genome genome = sketch.genome;
    const PartOrigin& origin = sketch.origins[part];
    const std::size_t parent = sketch.parent_of(part);
    std::vector<EdgeGene>& edges = edges_to(genome, sketch, part);
    EdgeGene& kept = edges[origin.edge];
    if (origin.image_by) {
        kept.position = aimed_position(sketch, parent, {}, joint_place(sketch, part));
        kept.angle =
            aimed_angle(sketch, parent, {}, kept.position, sketch.body.plan.parts[part].rest_angle);
        kept.reflect = !edges[*origin.partner].reflect;
    }
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(*origin.partner));
    genome.nodes[sketch.body.parts[part].node].symmetric = false;
    return genome;
}

}  // namespace

Genome remove_part(const BodySketch& sketch, std::size_t part, const SketchRules& rules) {
    CAMBRIAN_ASSERT(part > 0, "the root stays");
    Genome genome = sketch.genome;
    const std::uint8_t index = sketch.body.parts[part].node;
    std::vector<EdgeGene>& edges = edges_to(genome, sketch, part);
    const PartOrigin& origin = sketch.origins[part];
    const bool is_copy = sketch.body.parts[sketch.parent_of(part)].node == index;
    const int before = occurrence(sketch, part) - 1;
    if (is_copy && before > 1) {
        genome.nodes[index].recursion_limit = before;
    } else if (is_copy) {
        end_repetition(genome.nodes[index], index);
    } else {
        if (origin.partner)
            edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(*origin.partner));
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(origin.edge));
    }
    repair(genome, rules.kinds.catalog);
    return genome;
}

int repeats_of(const BodySketch& sketch, std::size_t part) {
    const std::uint8_t index = sketch.body.parts[part].node;
    const NodeGene& node = sketch.genome.nodes[index];
    const bool repeats =
        std::any_of(node.edges.begin(), node.edges.end(),
                    [index](const EdgeGene& edge) { return edge.target == index; });
    return repeats ? node.recursion_limit : 1;
}

Result<Genome> repeat_part(const BodySketch& sketch, std::size_t part, int times,
                           const SketchRules& rules) {
    Genome genome = sketch.genome;
    const std::uint8_t index = sketch.body.parts[part].node;
    NodeGene& node = genome.nodes[index];
    const bool repeated =
        std::any_of(node.edges.begin(), node.edges.end(),
                    [index](const EdgeGene& edge) { return edge.target == index; });
    if (times <= 1) {
        end_repetition(node, index);
    } else {
        if (!repeated && node.edges.size() >= gene_range::kMaxEdges)
            return Error{
                fmt::format("a part carries at most {} others, and its copy is one of them",
                            gene_range::kMaxEdges)};
        if (!repeated) {
            for (EdgeGene& edge : node.edges)
                edge.terminal_only = is_at_end(edge);
            node.edges.push_back({.target = index, .position = kEndOfPart});
        }
        node.recursion_limit = std::min(times, gene_range::kMaxRecursion);
    }
    repair(genome, rules.kinds.catalog);
    return genome;
}

bool is_paired(const BodySketch& sketch, std::size_t part) {
    return part > 0 && sketch.origins[part].partner.has_value();
}

Result<Genome> switch_pair(const BodySketch& sketch, std::size_t part, MirrorSides sides,
                           const SketchRules& rules) {
    CAMBRIAN_ASSERT(part > 0, "the root is one");
    if (is_paired(sketch, part)) {
        Genome alone = unpaired(sketch, part);
        repair(alone, rules.kinds.catalog);
        return alone;
    }
    Genome genome = sketch.genome;
    const std::size_t parent = sketch.parent_of(part);
    std::vector<EdgeGene>& edges = edges_to(genome, sketch, part);
    if (edges.size() >= gene_range::kMaxEdges)
        return Error{fmt::format("a part carries at most {} others", gene_range::kMaxEdges)};
    NodeGene& node = genome.nodes[sketch.body.parts[part].node];
    node.symmetric = true;
    node.mirror_axis = axis_of(sides, sketch.body.plan.parts[parent].rest_angle);
    const EdgeGene twin = edges[sketch.origins[part].edge];
    edges.insert(edges.begin() + static_cast<std::ptrdiff_t>(sketch.origins[part].edge) + 1, twin);
    repair(genome, rules.kinds.catalog);
    if (sketch_of(genome, rules).body.parts.size() <= sketch.body.parts.size())
        return Error{
            "its mirror image would lie on it, or there is no room for more parts; move it aside "
            "first"};
    return genome;
}

}  // namespace cambrian
