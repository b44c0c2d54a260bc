#include "sketch/body_sketch.h"

#include "core/assert.h"
#include "math/elementary.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

Vec3 size_of(const BodyPart& part) {
    return {part.length, part.width, part.thickness};
}

// Compares a part with what an edge of its parent makes.
class OriginSearch {
public:
    OriginSearch(const BodySketch& sketch, const Placement& placement, std::size_t part)
        : sketch_(sketch), placement_(placement), part_(part), parent_(sketch.parent_of(part)) {}

    PartOrigin run() const {
        const std::vector<EdgeGene>& edges = sketch_.node_of(parent_).edges;
        std::vector<bool> paired(edges.size(), false);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (paired[i]) continue;
            PartOrigin origin{.edge = i, .scale = sketch_.origins[parent_].scale * edges[i].scale};
            const NodeGene& target = sketch_.genome.nodes[edges[i].target];
            if (target.symmetric) origin.partner = partner_of(edges, i);
            if (origin.partner) paired[*origin.partner] = true;
            if (edges[i].target != sketch_.body.parts[part_].node || !has_size(origin)) continue;
            const Attachment place =
                placement_.attachment(edges[i], size_of(sketch_.body.parts[parent_]));
            if (is_at(place)) return origin;
            if (!origin.partner || !is_at(placement_.mirrored(place, target.mirror_axis))) continue;
            origin.image_by = target.mirror_axis;
            return origin;
        }
        CAMBRIAN_ASSERT(false, "an edge of its parent placed each part");
        return {};
    }

private:
    // Edges are followed in pairs among those that end repetitions, or among those that do not.
    static std::optional<std::size_t> partner_of(const std::vector<EdgeGene>& edges,
                                                 std::size_t first) {
        for (std::size_t next = first + 1; next < edges.size(); ++next) {
            if (edges[next].target == edges[first].target &&
                edges[next].terminal_only == edges[first].terminal_only)
                return next;
        }
        return {};
    }

    bool has_size(const PartOrigin& origin) const {
        const BodyPart& part = sketch_.body.parts[part_];
        const NodeGene& node = sketch_.node_of(part_);
        return part.length == std::clamp(origin.scale * node.length, gene_range::kMinSize,
                                         gene_range::kMaxLength) &&
               part.width == std::clamp(origin.scale * node.width, gene_range::kMinSize,
                                        gene_range::kMaxWidth);
    }

    bool is_at(const Attachment& place) const {
        const auto& planned = sketch_.body.plan.parts;
        const PlannedPart placed =
            placement_.place_child(planned[parent_], sketch_.body.parts[parent_].mirror, place,
                                   size_of(sketch_.body.parts[part_]));
        return placed.rest_pose.position == planned[part_].rest_pose.position &&
               placed.rest_angle == planned[part_].rest_angle;
    }

    const BodySketch& sketch_;
    const Placement& placement_;
    std::size_t part_;
    std::size_t parent_;
};

Vec2 turned(const Vec2& v, double angle) {
    const SineCosine turn = sine_cosine(angle);
    return {turn.cosine * v.x() - turn.sine * v.y(), turn.sine * v.x() + turn.cosine * v.y()};
}

}  // namespace

BodySketch sketch_of(Genome genome, const SketchRules& rules) {
    CAMBRIAN_ASSERT(genome.dimensions == 2, "a genome of the plane");
    BodySketch sketch{std::move(genome), {}, {}};
    sketch.body = express(sketch.genome, rules.kinds, rules.expression, rules.scene);
    sketch.origins.push_back({});
    for (std::size_t part = 1; part < sketch.body.parts.size(); ++part)
        sketch.origins.push_back(OriginSearch(sketch, rules.kinds.placement, part).run());
    return sketch;
}

PartName name_of(const BodySketch& sketch, std::size_t part) {
    const BodyPart& named = sketch.body.parts[part];
    return {sketch.node_of(part).uid, named.instance, named.node};
}

std::optional<std::size_t> find_part(const BodySketch& sketch, const PartName& name) {
    std::optional<std::size_t> moved;
    for (std::size_t part = 0; part < sketch.body.parts.size(); ++part) {
        const PartName found = name_of(sketch, part);
        if (found == name) return part;
        if (!moved && found.uid == name.uid && found.instance == name.instance) moved = part;
    }
    return moved;
}

Vec2 in_world(const PlannedPart& part, const Vec2& inside) {
    return part.rest_pose.position.head<2>() + turned(inside, part.rest_angle);
}

Vec2 into_part(const PlannedPart& part, const Vec2& world) {
    return turned(world - part.rest_pose.position.head<2>(), -part.rest_angle);
}

Vec2 joint_place(const BodySketch& sketch, std::size_t part) {
    return in_world(sketch.body.plan.parts[part],
                    sketch.body.plan.parts[part].anchor_in_child.head<2>());
}

}  // namespace cambrian
