#include "creature/morphogenesis.h"

#include "core/assert.h"
#include "creature/placement.h"
#include "genome/genome_graph.h"
#include "math/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace cambrian {
namespace {

// Data of a part that is needed only during growth.
struct Growing {
    double scale = 1.0;
    // Number of copies of each node on the path from the root, the part itself included.
    std::array<std::uint8_t, gene_range::kMaxNodes> occurrences{};
};

// A part that may be added to the body.
struct Bud {
    BodyPart part;
    PlannedPart body;
    Growing growing;
};

MotorMode mode_of(const std::string& id) {
    const auto found = std::find(kMotorModeIds.begin(), kMotorModeIds.end(), id);
    CAMBRIAN_ASSERT(found != kMotorModeIds.end(), "settings were checked");
    return static_cast<MotorMode>(found - kMotorModeIds.begin());
}

class Growth {
public:
    Growth(const Genome& genome, const Kinds& kinds, const ExpressionSettings& settings,
           const SceneSettings& scene, Side side, Phenotype& phenotype)
        : genome_(genome),
          scene_kind_(kinds.scene),
          placement_(kinds.placement),
          organs_(kinds.organs),
          is_spatial_(kinds.scene.dimensions == 3),
          settings_(settings),
          scene_(scene),
          motor_mode_(mode_of(scene.motor_mode)),
          is_mirrored_(side == Side::kMirrored),
          phenotype_(phenotype),
          reaches_(reachability(genome)),
          neurons_(genome.brain.size()) {}

    void run() {
        add(root());
        for (std::size_t parent = 0; parent < phenotype_.parts.size(); ++parent)
            sprout(parent);
        make_deformable();
    }

private:
    using Edges = std::vector<const EdgeGene*>;

    const NodeGene& gene(const BodyPart& part) const { return genome_.nodes[part.node]; }

    static Vec3 size_of(const BodyPart& part) { return {part.length, part.width, part.thickness}; }

    Bud root() const {
        const NodeGene& node = genome_.nodes[0];
        Bud bud;
        bud.part.length = node.length;
        bud.part.width = node.width;
        if (is_spatial_) bud.part.thickness = node.depth;
        if (is_mirrored_) bud.part.mirror.across = -1;
        bud.body = placement_.place_root(size_of(bud.part), genome_, is_mirrored_);
        bud.growing.occurrences[0] = 1;
        return bud;
    }

    Edges followable(std::size_t parent, bool terminal) const {
        const BodyPart& part = phenotype_.parts[parent];
        Edges edges;
        if (part.depth >= settings_.max_depth) return edges;
        for (const EdgeGene& edge : gene(part).edges) {
            const int occurrences = growing_[parent].occurrences[edge.target];
            const bool open = occurrences < genome_.nodes[edge.target].recursion_limit;
            if (open && edge.terminal_only == terminal) edges.push_back(&edge);
        }
        return edges;
    }

    // Terminal-only edges are followed if no normal edge leads back to this node.
    void sprout(std::size_t parent) {
        const Edges normal = followable(parent, false);
        const std::uint8_t node = phenotype_.parts[parent].node;
        const bool recursed = std::any_of(normal.begin(), normal.end(), [&](const EdgeGene* edge) {
            return reaches_[edge->target][node];
        });
        follow(parent, normal);
        if (!recursed) follow(parent, followable(parent, true));
    }

    // Edges to a symmetric node are followed in pairs, both at the position of the first. The last
    // edge of an odd number is followed alone.
    void follow(std::size_t parent, const Edges& edges) {
        std::vector<bool> paired(edges.size(), false);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (paired[i]) continue;
            const NodeGene& target = genome_.nodes[edges[i]->target];
            const Attachment place = attachment_of(parent, *edges[i]);
            std::vector<Bud> buds = {bud(parent, *edges[i], edges[i]->scale, place)};
            const std::size_t partner = target.symmetric ? partner_of(i, edges) : edges.size();
            if (partner < edges.size()) {
                paired[partner] = true;
                buds.push_back(bud(parent, *edges[partner], edges[i]->scale,
                                   placement_.mirrored(place, target.mirror_axis)));
                BodyPart& image = buds.back().part;
                image.mirror = placement_.flipped(image.mirror, target.mirror_axis);
            }
            try_add(buds);
        }
    }

    // Returns the next edge to the same node, or edges.size() if there is none.
    static std::size_t partner_of(std::size_t first, const Edges& edges) {
        std::size_t next = first + 1;
        while (next < edges.size() && edges[next]->target != edges[first]->target)
            ++next;
        return next;
    }

    Attachment attachment_of(std::size_t parent, const EdgeGene& edge) const {
        return placement_.attachment(edge, size_of(phenotype_.parts[parent]));
    }

    Bud bud(std::size_t parent, const EdgeGene& edge, double scale, const Attachment& place) const {
        const NodeGene& node = genome_.nodes[edge.target];
        const BodyPart& from = phenotype_.parts[parent];
        Bud bud;
        bud.growing = growing_[parent];
        bud.growing.scale *= scale;
        ++bud.growing.occurrences[edge.target];
        CAMBRIAN_TICK_ASSERT(edge.target < genome_.nodes.size(), "an edge leads to a node");
        bud.part.node = edge.target;
        bud.part.parent = static_cast<int>(parent);
        bud.part.depth = from.depth + 1;
        bud.part.mirror = {from.mirror.across * (edge.reflect ? -1 : 1),
                           from.mirror.depth * (edge.reflect_depth ? -1 : 1)};
        bud.part.length = std::clamp(bud.growing.scale * node.length, gene_range::kMinSize,
                                     gene_range::kMaxLength);
        bud.part.width =
            std::clamp(bud.growing.scale * node.width, gene_range::kMinSize, gene_range::kMaxWidth);
        if (is_spatial_)
            bud.part.thickness = std::clamp(bud.growing.scale * node.depth, gene_range::kMinSize,
                                            gene_range::kMaxWidth);
        bud.body = placement_.place_child(phenotype_.plan.parts[parent], from.mirror, place,
                                          size_of(bud.part));
        return bud;
    }

    // Adds all of the parts or none.
    void try_add(std::span<const Bud> buds) {
        if (!has_room(buds)) return;
        for (std::size_t i = 0; i < buds.size(); ++i) {
            if (buried(buds[i]) || (i > 0 && placement_.is_buried(buds[i].body, buds[0].body)))
                return;
        }
        for (const Bud& bud : buds)
            add(bud);
    }

    bool has_room(std::span<const Bud> buds) const {
        std::size_t neurons = neurons_;
        for (const Bud& bud : buds)
            neurons += gene(bud.part).neurons.size();
        return phenotype_.parts.size() + buds.size() <=
                   static_cast<std::size_t>(settings_.max_parts) &&
               neurons <= static_cast<std::size_t>(settings_.max_neurons);
    }

    bool buried(const Bud& bud) const {
        for (std::size_t i = 0; i < phenotype_.parts.size(); ++i) {
            const bool is_parent = static_cast<int>(i) == bud.part.parent;
            if (!is_parent && placement_.is_buried(bud.body, phenotype_.plan.parts[i])) return true;
        }
        return false;
    }

    void add(Bud bud) {
        bud.part.instance = instances_[bud.part.node]++;
        bud.body.parent = bud.part.parent;
        if (bud.part.parent >= 0) set_joint(bud.part, bud.body);
        CAMBRIAN_TICK_ASSERT(bud.part.parent < static_cast<int>(phenotype_.parts.size()),
                             "a parent comes before its children");
        CAMBRIAN_TICK_ASSERT(bud.part.length > 0.0 && bud.part.width > 0.0, "a part has an area");
        neurons_ += gene(bud.part).neurons.size();
        phenotype_.parts.push_back(bud.part);
        phenotype_.plan.parts.push_back(bud.body);
        growing_.push_back(bud.growing);
    }

    void set_joint(const BodyPart& part, PlannedPart& body) const {
        const NodeGene& node = gene(part);
        const JointKind& joint = scene_kind_.joints[node.joint];
        body.motion = joint.motion;
        CAMBRIAN_TICK_ASSERT(joint.motion == JointMotion::kFixed || joint.shape != nullptr,
                             "a joint that moves has a shape");
        body.motor_mode = motor_mode_;
        if (joint.motion == JointMotion::kFixed) return;
        const BodyPart& parent = phenotype_.parts[static_cast<std::size_t>(part.parent)];
        JointGenes genes{.limit_low = node.limit_low,
                         .limit_high = node.limit_high,
                         .length = part.length,
                         .width = std::fmin(part.width, parent.width),
                         .mirror = part.mirror,
                         .muscle_strength = scene_.muscle_strength,
                         .depth = std::fmin(part.thickness, parent.thickness)};
        for (std::size_t i = 0; i < node.further.size(); ++i)
            genes.further_limits[i] = {node.further[i].limit_low, node.further[i].limit_high};
        joint.shape(genes, body);
        CAMBRIAN_TICK_ASSERT(body.limit_low <= body.limit_high && body.max_effort >= 0.0,
                             "stops in order and some strength");
    }

    // Parts deform in the order of their creation while there is room.
    void make_deformable() {
        const int parts = static_cast<int>(phenotype_.parts.size());
        int left = std::min(kMostDeformers, kPlacesOfParts - parts);
        for (std::size_t i = 0; i < phenotype_.parts.size(); ++i) {
            PlannedPart& body = phenotype_.plan.parts[i];
            for (const OrganGene& organ : gene(phenotype_.parts[i]).organs) {
                const OrganKind& kind = organs_[organ.kind];
                if (kind.shape == nullptr || body.stretch || left <= 0) continue;
                kind.shape({organ.parameters.data(), kind.parameters.size()}, scene_, body);
                --left;
            }
        }
    }

    const Genome& genome_;
    const SceneKind& scene_kind_;
    const Placement& placement_;
    const OrganRegistry& organs_;
    bool is_spatial_;
    const ExpressionSettings& settings_;
    const SceneSettings& scene_;
    MotorMode motor_mode_;
    bool is_mirrored_;
    Phenotype& phenotype_;
    Reachability reaches_;
    std::vector<Growing> growing_;  // one per part
    std::array<std::uint8_t, gene_range::kMaxNodes> instances_{};
    std::size_t neurons_;  // number of neurons so far, central ones included
};

}  // namespace

void grow(const Genome& genome, const Kinds& kinds, const ExpressionSettings& settings,
          const SceneSettings& scene, Side side, Phenotype& phenotype) {
    Growth(genome, kinds, settings, scene, side, phenotype).run();
}

}  // namespace cambrian
