#include "sketch/strokes.h"

#include "core/assert.h"
#include "math/angle.h"
#include "sketch/outline.h"
#include "sketch/pairs.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kNewLimit = to_radians(60.0);
// Of the width of a new part.
constexpr double kSlimness = 0.28;  // share of its length
constexpr double kLeastNewWidth = 0.08;
constexpr double kMostNewWidth = 0.22;

double fitting_length(double length, double scale) {
    return std::clamp(length / scale, gene_range::kMinSize, gene_range::kMaxLength);
}

double direction(const Vec2& v) {
    return arc_tangent2(v.y(), v.x());
}

Vec2 unit(double angle) {
    const SineCosine turn = sine_cosine(angle);
    return {turn.cosine, turn.sine};
}

std::uint8_t hinge(const JointRegistry& joints) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (joints[i].motion == JointMotion::kTurn && joints[i].degrees_of_freedom() == 1)
            return static_cast<std::uint8_t>(i);
    }
    return 0;
}

std::uint32_t unused_uid(const Genome& genome) {
    std::uint32_t uid = 1;
    const auto is_used = [&](const NodeGene& node) { return node.uid == uid; };
    while (std::any_of(genome.nodes.begin(), genome.nodes.end(), is_used))
        ++uid;
    return uid;
}

// Changes the edge that placed a part, and its partner.
template <class Change>
void change_edges(Genome& genome, const BodySketch& sketch, std::size_t part,
                  const Change& change) {
    std::vector<EdgeGene>& edges =
        genome.nodes[sketch.body.parts[sketch.parent_of(part)].node].edges;
    change(edges[sketch.origins[part].edge]);
    if (sketch.origins[part].partner) change(edges[*sketch.origins[part].partner]);
}

bool is_repeated(const BodySketch& sketch, std::size_t part) {
    const std::uint8_t node = sketch.body.parts[part].node;
    const std::vector<EdgeGene>& edges = sketch.genome.nodes[node].edges;
    return std::any_of(edges.begin(), edges.end(),
                       [node](const EdgeGene& edge) { return edge.target == node; });
}

// Returns where the part with that uid is in a body that grew from the sketch, or nothing. The
// parent has the same index in both, since the parts before it did not change.
std::vector<std::size_t> grown_at(const BodySketch& grown, std::uint32_t uid, std::size_t parent) {
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < grown.body.parts.size(); ++i) {
        if (grown.node_of(i).uid == uid && grown.parent_of(i) == parent) found.push_back(i);
    }
    return found;
}

class Sprout {
public:
    Sprout(const BodySketch& sketch, std::size_t parent, const NewPart& drawn,
           const SketchRules& rules)
        : sketch_(sketch), parent_(parent), drawn_(drawn), rules_(rules) {}

    Result<GrownPart> run() const {
        if (sketch_.genome.nodes.size() >= gene_range::kMaxNodes)
            return Error{
                fmt::format("a body has at most {} kinds of parts", gene_range::kMaxNodes)};
        if (sketch_.body.parts.size() >= static_cast<std::size_t>(rules_.expression.max_parts))
            return Error{fmt::format("a body has at most {} parts here (Parts at most)",
                                     rules_.expression.max_parts)};
        if (drawn_.mirror != MirrorSides::kNone && !is_on_both_sides(sketch_, parent_)) {
            if (auto pair = tried(2)) return *std::move(pair);
        }
        if (auto single = tried(1)) return *std::move(single);
        if (room_for_edges() == 0)
            return Error{fmt::format("a part carries at most {} others", gene_range::kMaxEdges)};
        return Error{"a part cannot grow inside another one, nor too many joints from the root"};
    }

private:
    std::size_t room_for_edges() const {
        return gene_range::kMaxEdges - sketch_.node_of(parent_).edges.size();
    }

    // Returns the body with so many images of the part, or nothing if they do not grow.
    std::optional<GrownPart> tried(std::size_t images) const {
        if (room_for_edges() < images) return {};
        Genome genome = sketch_.genome;
        const std::uint32_t uid = unused_uid(genome);
        EdgeGene edge = aimed();
        edge.target = static_cast<std::uint8_t>(genome.nodes.size());
        genome.nodes.push_back(node(edge, uid, images == 2));
        for (std::size_t i = 0; i < images; ++i)
            genome.nodes[sketch_.body.parts[parent_].node].edges.push_back(edge);
        repair(genome, rules_.kinds.catalog);
        const BodySketch grown = sketch_of(genome, rules_);
        const std::vector<std::size_t> parts = grown_at(grown, uid, parent_);
        if (parts.size() < images) return {};
        return GrownPart{std::move(genome), name_of(grown, parts.front())};
    }

    EdgeGene aimed() const {
        EdgeGene edge;
        edge.position = aimed_position(sketch_, parent_, {}, drawn_.from);
        edge.angle = aimed_angle(sketch_, parent_, {}, edge.position, direction(reach()));
        edge.terminal_only = edge.position < 0.25 && is_repeated(sketch_, parent_);
        return edge;
    }

    Vec2 reach() const {
        const PlannedPart& body = sketch_.body.plan.parts[parent_];
        const Vec2 inside = into_part(body, drawn_.from);
        return drawn_.to -
               in_world(body, nearest_on_outline(sketch_.body.parts[parent_], inside).point);
    }

    NodeGene node(const EdgeGene& edge, std::uint32_t uid, bool paired) const {
        const double scale = sketch_.origins[parent_].scale;
        const double along = reach().dot(unit(direction_of(sketch_, parent_, {}, edge)));
        NodeGene node;
        node.uid = uid;
        node.length = fitting_length(along, scale);
        const double width =
            std::clamp(kSlimness * node.length * scale, kLeastNewWidth, kMostNewWidth);
        node.width = std::clamp(width / scale, gene_range::kMinSize, gene_range::kMaxWidth);
        node.joint = hinge(rules_.kinds.scene.joints);
        node.limit_low = -kNewLimit;
        node.limit_high = kNewLimit;
        node.effector.weight = 0.0;
        node.symmetric = paired;
        node.mirror_axis = axis_of(drawn_.mirror, sketch_.body.plan.parts[parent_].rest_angle);
        return node;
    }

    const BodySketch& sketch_;
    std::size_t parent_;
    const NewPart& drawn_;
    const SketchRules& rules_;
};

}  // namespace

MirrorAxis axis_of(MirrorSides sides, double part_angle) {
    const SineCosine turn = sine_cosine(part_angle);
    const bool lies = std::fabs(turn.cosine) >= std::fabs(turn.sine);
    return (sides == MirrorSides::kSideways) == lies ? MirrorAxis::kAcross : MirrorAxis::kAlong;
}

Result<GrownPart> grow_part(const BodySketch& sketch, std::size_t parent, const NewPart& drawn,
                            const SketchRules& rules) {
    return Sprout(sketch, parent, drawn, rules).run();
}

Genome drag_end(const BodySketch& sketch, std::size_t part, const Vec2& to) {
    Genome genome = sketch.genome;
    NodeGene& node = genome.nodes[sketch.body.parts[part].node];
    if (part == 0) {
        const Vec2 reach = to - sketch.body.plan.parts[0].rest_pose.position.head<2>();
        if (reach.norm() > 0.0) genome.root_angle = wrap_angle(direction(reach));
        node.length = fitting_length(2.0 * reach.norm(), 1.0);
        return genome;
    }
    const PartOrigin& origin = sketch.origins[part];
    const std::size_t parent = sketch.parent_of(part);
    const Vec2 reach = to - joint_place(sketch, part);
    EdgeGene edge = sketch.edge_of(part);
    if (reach.norm() > 0.0)
        edge.angle = aimed_angle(sketch, parent, origin.image_by, edge.position, direction(reach));
    const Vec2 axis = unit(direction_of(sketch, parent, origin.image_by, edge));
    node.length = fitting_length(reach.dot(axis), origin.scale);
    change_edges(genome, sketch, part, [&](EdgeGene& each) { each.angle = edge.angle; });
    return genome;
}

Genome drag_side(const BodySketch& sketch, std::size_t part, const Vec2& to) {
    Genome genome = sketch.genome;
    const double half = std::fabs(into_part(sketch.body.plan.parts[part], to).y());
    genome.nodes[sketch.body.parts[part].node].width = std::clamp(
        2.0 * half / sketch.origins[part].scale, gene_range::kMinSize, gene_range::kMaxWidth);
    return genome;
}

Genome slide_joint(const BodySketch& sketch, std::size_t part, const Vec2& to) {
    CAMBRIAN_ASSERT(part > 0, "the root has no joint");
    Genome genome = sketch.genome;
    const double position =
        aimed_position(sketch, sketch.parent_of(part), sketch.origins[part].image_by, to);
    change_edges(genome, sketch, part, [position](EdgeGene& edge) { edge.position = position; });
    return genome;
}

Genome first_part() {
    Genome genome;
    genome.nodes.resize(1);
    genome.nodes[0].uid = 1;
    genome.hue = 0.48;
    genome.nodes[0].length = 0.7;
    genome.nodes[0].width = 0.22;
    genome.nodes[0].effector.weight = 0.0;
    return genome;
}

}  // namespace cambrian
