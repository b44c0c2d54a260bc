#include "sketch/outline.h"

#include "core/random.h"
#include "math/angle.h"
#include "sketches.h"

namespace cambrian {
namespace {

using test::drawn;

// Returns a root that lies at an angle, with a child as an edge places it, perhaps mirrored.
Genome random_pair(RandomStream& stream) {
    Genome genome;
    genome.nodes.resize(3);
    genome.root_angle = stream.uniform(-kPi, kPi);
    for (NodeGene& node : genome.nodes) {
        node.length = stream.uniform(0.08, 1.6);
        node.width = stream.uniform(0.08, 0.96);
        node.mirror_axis = stream.chance(0.5) ? MirrorAxis::kAlong : MirrorAxis::kAcross;
    }
    // The middle part only turns the handedness, perhaps.
    genome.nodes[0].edges.push_back({.target = 1, .reflect = stream.chance(0.5)});
    EdgeGene edge{.target = 2,
                  .position = stream.uniform(),
                  .angle = stream.uniform(-1.4, 1.4),
                  .scale = stream.uniform(0.4, 1.5)};
    genome.nodes[1].edges.push_back(edge);
    genome.nodes[2].symmetric = stream.chance(0.5);
    if (genome.nodes[2].symmetric) genome.nodes[1].edges.push_back(edge);
    return genome;
}

TEST_CASE("the inverse of an attachment puts every part back where it was", "[sketch][outline]") {
    RandomStream stream(7);
    int parts = 0;
    int images = 0;
    for (int i = 0; parts < 10'000; ++i) {
        REQUIRE(i < 40'000);
        const BodySketch sketch = drawn(random_pair(stream));
        for (std::size_t part = 2; part < sketch.body.parts.size(); ++part) {
            const PartOrigin& origin = sketch.origins[part];
            const std::size_t parent = sketch.parent_of(part);
            const double direction = sketch.body.plan.parts[part].rest_angle;
            EdgeGene edge = sketch.edge_of(part);
            CHECK(wrap_angle(direction_of(sketch, parent, origin.image_by, edge) - direction) ==
                  Approx(0.0).margin(1e-9));
            edge.position =
                aimed_position(sketch, parent, origin.image_by, joint_place(sketch, part));
            edge.angle = aimed_angle(sketch, parent, origin.image_by, edge.position, direction);
            Genome again = sketch.genome;
            auto& edges = again.nodes[sketch.body.parts[parent].node].edges;
            edges[origin.edge] = edge;
            if (origin.partner) edges[*origin.partner] = edge;
            const BodySketch redrawn = drawn(again);
            REQUIRE(redrawn.body.parts.size() == sketch.body.parts.size());
            CHECK((joint_place(redrawn, part) - joint_place(sketch, part)).norm() < 1e-3);
            CHECK((test::far_end(redrawn, part) - test::far_end(sketch, part)).norm() < 1e-3);
            ++parts;
            images += origin.image_by ? 1 : 0;
        }
    }
    CHECK(images > 1000);
}

TEST_CASE("the nearest place of an outline is on the face that is looked at", "[sketch][outline]") {
    BodyPart part;
    part.length = 1.0;
    part.width = 0.2;
    CHECK(nearest_on_outline(part, {0.7, 0.0}).position == Approx(0.125));
    CHECK(nearest_on_outline(part, {0.0, 0.3}).position == Approx(0.375));
    CHECK(nearest_on_outline(part, {-0.9, 0.0}).position == Approx(0.625));
    CHECK(nearest_on_outline(part, {0.0, -0.3}).position == Approx(0.875));
    CHECK(nearest_on_outline(part, {0.0, 0.3}).distance == Approx(0.2));
    part.mirror.across = -1;
    CHECK(nearest_on_outline(part, {0.0, -0.3}).position == Approx(0.375));
}

TEST_CASE("corners belong to the faces between them", "[sketch][outline]") {
    BodyPart part;
    part.length = 1.0;
    part.width = 0.5;
    for (int face = 0; face < 4; ++face) {
        const double corner = 0.25 * face + 0.25;
        const Vec2 beyond[] = {{9.0, 0.26}, {-0.46, 9.0}, {-9.0, 0.26}, {0.46, -9.0}};
        const double position = nearest_on_outline(part, beyond[face]).position;
        CHECK(position >= 0.25 * face);
        CHECK(position < corner);
    }
}

}  // namespace
}  // namespace cambrian
