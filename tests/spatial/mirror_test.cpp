#include "creature/phenotype.h"
#include "genome/founders/random_gene.h"
#include "math/elementary.h"
#include "spatial/bodies.h"
#include "support/kinds.h"

#include <catch2/catch.hpp>

#include <array>

namespace cambrian {
namespace {

// A limb of two parts with a random outgrowth, twice at the root as mirror images.
Genome paired_limbs(MirrorAxis axis, const Kinds& kinds, RandomStream& random) {
    const FounderSettings settings;
    const GenePool pool{settings, kinds.catalog};
    Genome genome;
    genome.dimensions = 3;
    genome.nodes.resize(3);
    for (NodeGene& node : genome.nodes) {
        node = random_node(pool, random);
        node.symmetric = false;
        node.recursion_limit = 1;
        node.neurons.clear();
        for (std::size_t degree = 0; degree <= node.further.size(); ++degree)
            effector_of(node, degree) = {};
    }
    genome.nodes[1].symmetric = true;
    genome.nodes[1].mirror_axis = axis;
    const auto edge = [&](std::size_t target) {
        EdgeGene gene = random_edge(target, pool, random);
        gene.terminal_only = false;
        return gene;
    };
    genome.nodes[0].edges = {edge(1)};
    genome.nodes[0].edges.push_back(genome.nodes[0].edges.front());
    genome.nodes[1].edges = {edge(2)};
    repair(genome, kinds.catalog);
    return genome;
}

Vec3 image_of(const Vec3& point, MirrorAxis axis) {
    switch (axis) {
        case MirrorAxis::kAlong:
            return {point.x(), -point.y(), point.z()};
        case MirrorAxis::kAcross:
            return {-point.x(), point.y(), point.z()};
        case MirrorAxis::kDepth:
            break;
    }
    return {point.x(), point.y(), -point.z()};
}

}  // namespace

// Section 4.4 of the design: limbs that are driven alike move as mirror images.
TEST_CASE("Mirrored limbs in space move as mirror images") {
    const Kinds& kinds = test::spatial_kinds().creature;
    int tried = 0;
    int ends = 0;
    int exact = 0;
    for (std::uint64_t turn = 0; turn < 30; ++turn) {
        RandomStream random(stream_seed({107, turn}));
        const auto axis = static_cast<MirrorAxis>(turn % 3);
        const Genome genome = paired_limbs(axis, kinds, random);
        SceneSettings settings;
        settings.muscle_strength = 25000.0;
        const Phenotype phenotype = express(genome, kinds, {}, settings);
        if (phenotype.parts.size() != 5) continue;
        ++tried;
        const auto scene = make_solid(phenotype.plan, weightless(), settings);
        for (int tick = 0; tick < 300; ++tick) {
            for (std::size_t i = 0; i < phenotype.effectors.size(); ++i) {
                const JointDegree& effector = phenotype.effectors[i];
                const double node = phenotype.parts[effector.part].node;
                const double phase = 2.0 * node + effector.degree;
                const double wanted = 0.7 * sine(3.0 * scene->time() + phase) - 0.7 * sine(phase);
                scene->set_target(effector, phenotype.network.outputs[i].weight * wanted);
            }
            REQUIRE(scene->advance(1.0 / 60) == SceneStatus::kRunning);
        }
        const Pose root = scene->part_pose(0);
        const auto local = [&root](const Vec3& point) {
            return root.orientation.conjugate() * (point - root.position);
        };
        // Parts 1 and 2 are a pair, and so are those that grow on them.
        for (const std::array<std::size_t, 2>& pair :
             {std::array<std::size_t, 2>{1, 2}, std::array<std::size_t, 2>{3, 4}}) {
            REQUIRE(phenotype.parts[pair[0]].node == phenotype.parts[pair[1]].node);
            for (const double share : {-1.0, 1.0}) {
                const Vec3 one = local(point_on_axis(*scene, pair[0], share));
                const Vec3 other = local(point_on_axis(*scene, pair[1], share));
                CAPTURE(turn, pair[0], share);
                const double apart = (image_of(one, axis) - other).norm();
                ++ends;
                exact += apart < 1e-10 ? 1 : 0;
                // Rounding can let one of a pair meet a stop a step earlier than the other.
                CHECK(apart < 1e-4);
            }
        }
    }
    CHECK(tried > 10);
    CHECK(exact > 0.9 * ends);
}

}  // namespace cambrian
