#include "creature/builders.h"
#include "math/angle.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

std::vector<int> nodes_of(const Phenotype& phenotype) {
    std::vector<int> nodes;
    for (const BodyPart& part : phenotype.parts)
        nodes.push_back(part.node);
    return nodes;
}

}  // namespace

TEST_CASE("a self-connected part grows a chain as long as its recursion limit",
          "[creature][morphogenesis]") {
    const Phenotype chain = express(genome_of({node_with({edge_to(0)}, 5)}));
    CHECK(chain.parts.size() == 5);
    CHECK(chain.parts.back().depth == 4);
    CHECK(chain.parts.back().instance == 4);
    CHECK(chain.rest_length() == Approx(std::hypot(2.5, 0.2)));
}

TEST_CASE("a terminal edge grows only where recursion has ended", "[creature][morphogenesis]") {
    EdgeGene tip = edge_to(1);
    tip.terminal_only = true;
    const Phenotype chain = express(genome_of({node_with({edge_to(0), tip}, 5), NodeGene{}}));
    CHECK(nodes_of(chain) == std::vector<int>{0, 0, 0, 0, 0, 1});
    CHECK(chain.parts.back().parent == 4);
}

TEST_CASE("a terminal edge grows on a part in no cycle", "[creature][morphogenesis]") {
    EdgeGene tip = edge_to(1);
    tip.terminal_only = true;
    CHECK(express(genome_of({node_with({tip}), NodeGene{}})).parts.size() == 2);
}

TEST_CASE("two parts in a cycle with limits of two alternate four times",
          "[creature][morphogenesis]") {
    const Phenotype chain =
        express(genome_of({node_with({edge_to(1)}, 2), node_with({edge_to(0)}, 2)}));
    CHECK(nodes_of(chain) == std::vector<int>{0, 1, 0, 1});
}

TEST_CASE("a mirror pair is grown completely or not at all", "[creature][morphogenesis]") {
    NodeGene body = node_with({edge_to(1), edge_to(2, 0.3), edge_to(2, 0.3)});
    NodeGene leg;
    leg.symmetric = true;
    const Genome genome = genome_of({body, NodeGene{}, leg});
    CHECK(express(genome).parts.size() == 4);
    CHECK(nodes_of(express(genome, {.max_parts = 3})) == std::vector<int>{0, 1});
}

TEST_CASE("an odd edge to a symmetric part grows alone", "[creature][morphogenesis]") {
    NodeGene leg;
    leg.symmetric = true;
    const NodeGene body = node_with({edge_to(1, 0.3), edge_to(1, 0.3), edge_to(1, 0.6)});
    const Phenotype grown = express(genome_of({body, leg}));
    REQUIRE(grown.parts.size() == 4);
    CHECK(grown.parts[2].mirror.across == -1);
    CHECK(grown.parts[3].mirror.across == 1);
}

TEST_CASE("a pair whose members would coincide is not grown", "[creature][morphogenesis]") {
    NodeGene leg;
    leg.symmetric = true;
    Genome genome = genome_of({node_with({edge_to(1, 0.125), edge_to(1, 0.125)}), leg});
    CHECK(express(genome).parts.size() == 1);
    genome.nodes[0].edges[0].angle = 0.5;
    CHECK(express(genome).parts.size() == 3);
}

TEST_CASE("growth ends at the depth limit", "[creature][morphogenesis]") {
    const NodeGene first = node_with({edge_to(1)}, 6);
    const NodeGene second = node_with({edge_to(0)}, 6);
    const Phenotype chain = express(genome_of({first, second}));
    CHECK(chain.parts.size() == 11);
    CHECK(chain.parts.back().depth == 10);
}

TEST_CASE("reflect turns a curl into a zigzag", "[creature][morphogenesis]") {
    Genome genome = genome_of({node_with({edge_to(0, 0.125, 0.5)}, 4)});
    const Phenotype curl = express(genome);
    CHECK(curl.plan.parts[3].rest_angle == Approx(1.5));
    genome.nodes[0].edges[0].reflect = true;
    const Phenotype zigzag = express(genome);
    CHECK(zigzag.plan.parts[1].rest_angle == Approx(0.5));
    CHECK(zigzag.plan.parts[2].rest_angle == Approx(0.0).margin(1e-12));
    CHECK(zigzag.plan.parts[3].rest_angle == Approx(0.5));
}

TEST_CASE("mirror partners are mirror images about their parent's axis",
          "[creature][morphogenesis]") {
    const auto check = [](MirrorAxis axis, double x_sign, double y_sign) {
        Genome genome = two_legs();
        genome.nodes[1].mirror_axis = axis;
        const Phenotype body = express(genome);
        REQUIRE(body.parts.size() == 3);
        const Vec3 left = body.plan.parts[1].rest_pose.position;
        const Vec3 right = body.plan.parts[2].rest_pose.position;
        CHECK(right.x() == Approx(x_sign * left.x()));
        CHECK(right.y() == Approx(y_sign * left.y()));
        CHECK(body.parts[1].mirror.across == 1);
        CHECK(body.parts[2].mirror.across == -1);
        CHECK(body.plan.parts[2].limit_low == -body.plan.parts[1].limit_high);
        CHECK(body.plan.parts[2].limit_high == -body.plan.parts[1].limit_low);
    };
    check(MirrorAxis::kAlong, 1.0, -1.0);
    check(MirrorAxis::kAcross, -1.0, 1.0);
}

TEST_CASE("scale shrinks all of a subtree, within the limits of size",
          "[creature][morphogenesis]") {
    EdgeGene edge = edge_to(0);
    edge.scale = 0.5;
    const Phenotype chain = express(genome_of({node_with({edge}, 4)}));
    CHECK(chain.parts[1].length == Approx(0.25));
    CHECK(chain.parts[2].length == Approx(0.125));
    CHECK(chain.parts[3].length == gene_range::kMinSize);
    CHECK(chain.parts[1].width == Approx(0.1));
}

TEST_CASE("children leave each face along its outward normal", "[creature][morphogenesis]") {
    const std::array<Vec2, 4> anchors = {Vec2(0.25, 0), Vec2(0, 0.1), Vec2(-0.25, 0),
                                         Vec2(0, -0.1)};
    const std::array<double, 4> angles = {0.0, 0.5 * kPi, kPi, -0.5 * kPi};
    for (std::size_t face = 0; face < 4; ++face) {
        const double position = 0.125 + 0.25 * static_cast<double>(face);
        const Phenotype body = express(genome_of({node_with({edge_to(1, position)}), NodeGene{}}));
        const PlannedPart& child = body.plan.parts[1];
        CHECK((child.anchor_in_parent.head<2>() - anchors[face]).norm() < 1e-12);
        CHECK(child.rest_angle == Approx(angles[face]));
        const Vec3 joint = transform(child.rest_pose, child.anchor_in_child);
        CHECK((joint - child.anchor_in_parent).norm() < 1e-12);
    }
}

TEST_CASE("a part buried in another is dropped with its subtree", "[creature][morphogenesis]") {
    const NodeGene body = node_with({edge_to(1, 0.125), edge_to(2, 0.13)});
    const Genome genome = genome_of({body, NodeGene{}, node_with({edge_to(3)}), NodeGene{}});
    CHECK(nodes_of(express(genome)) == std::vector<int>{0, 1});
    Genome apart = genome;
    apart.nodes[0].edges[1].angle = to_radians(18.0);
    CHECK(express(apart).parts.size() == 4);
}

TEST_CASE("muscles grow with the narrower part's section", "[creature][morphogenesis]") {
    Genome genome = genome_of({node_with({edge_to(1)}), NodeGene{}});
    genome.nodes[0].width = 0.3;
    genome.nodes[1].width = 0.5;
    CHECK(express(genome).plan.parts[1].max_effort == Approx(25.0 * 0.09));
    genome.nodes[1].joint = 2;
    CHECK(express(genome).plan.parts[1].max_effort == Approx(25.0 * 0.3));
}

TEST_CASE("a sliding joint's limits are shares of its part's length, mirrored or not",
          "[creature][morphogenesis]") {
    Genome genome = two_legs();
    genome.nodes[1].joint = 2;
    genome.nodes[1].length = 0.5;
    const Phenotype body = express(genome);
    for (const std::size_t leg : {1UL, 2UL}) {
        CHECK(body.plan.parts[leg].limit_low == Approx(-0.2));
        CHECK(body.plan.parts[leg].limit_high == Approx(0.45));
    }
}
