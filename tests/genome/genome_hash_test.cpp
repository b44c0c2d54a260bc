#include "genome/founders/random_genome.h"
#include "genome/genome.h"
#include "genome/small_catalog.h"
#include "support/catch.h"

#include <functional>

using namespace cambrian;

namespace {

Genome founder() {
    RandomStream stream(stream_seed(5, 0, 0, Purpose::kTest));
    FounderSettings settings;
    settings.min_nodes = 3;
    return random_genome(settings, small_catalog(), stream);
}

}  // namespace

TEST_CASE("hue, name and uids change neither hash nor equality", "[genome][hash]") {
    const Genome genome = founder();
    Genome other = genome;
    other.hue = 0.123;
    other.name = "Grendel";
    other.nodes[1].uid += 1;
    CHECK(other == genome);
    CHECK(genome_hash(other) == genome_hash(genome));
}

TEST_CASE("every gene changes hash and equality", "[genome][hash]") {
    const std::vector<std::function<void(Genome&)>> changes = {
        [](Genome& g) { g.root_angle += 0.1; },
        [](Genome& g) { g.reproduction = 3; },
        [](Genome& g) {
            g.brain.push_back({2, {{}}});
        },
        [](Genome& g) { g.nodes[1].length += 1e-9; },
        [](Genome& g) { g.nodes[1].width += 1e-9; },
        [](Genome& g) { g.nodes[1].joint ^= 1; },
        [](Genome& g) { g.nodes[1].limit_low -= 1e-9; },
        [](Genome& g) { g.nodes[1].limit_high += 1e-9; },
        [](Genome& g) { g.nodes[1].recursion_limit += 1; },
        [](Genome& g) { g.nodes[1].symmetric = !g.nodes[1].symmetric; },
        [](Genome& g) { g.nodes[1].mirror_axis = MirrorAxis(1 - int(g.nodes[1].mirror_axis)); },
        [](Genome& g) { g.nodes[1].effector.weight += 1e-9; },
        [](Genome& g) { g.nodes[1].effector.source.index ^= 1; },
        [](Genome& g) { g.nodes[1].organs.emplace_back(); },
        [](Genome& g) { g.nodes[0].organs.resize(3); },
        [](Genome& g) {
            g.nodes[1].neurons.push_back({2, {{}}});
        },
        [](Genome& g) { g.nodes[0].edges[0].target += 1; },
        [](Genome& g) { g.nodes[0].edges[0].position += 1e-9; },
        [](Genome& g) { g.nodes[0].edges[0].angle += 1e-9; },
        [](Genome& g) { g.nodes[0].edges[0].scale += 1e-9; },
        [](Genome& g) { g.nodes[0].edges[0].reflect ^= true; },
        [](Genome& g) { g.nodes[0].edges[0].terminal_only ^= true; },
    };
    const Genome genome = founder();
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Genome other = genome;
        changes[i](other);
        INFO("change " << i);
        CHECK_FALSE(other == genome);
        CHECK(genome_hash(other) != genome_hash(genome));
    }
}

TEST_CASE("every gene of an organ changes hash and equality", "[genome][hash]") {
    const std::vector<std::function<void(OrganGene&)>> changes = {
        [](OrganGene& organ) { organ.kind = 1; },
        [](OrganGene& organ) { organ.input.weight += 1e-9; },
        [](OrganGene& organ) { organ.input.source.kind = SourceKind::kLocalSensor; },
        [](OrganGene& organ) { organ.parameters[0] = 2.0; },
        [](OrganGene& organ) { organ.parameters[1] = 2.0; },
    };
    Genome genome = founder();
    genome.nodes[1].organs.resize(2);
    for (const auto& change : changes) {
        Genome other = genome;
        change(other.nodes[1].organs[1]);
        CHECK_FALSE(other == genome);
        CHECK(genome_hash(other) != genome_hash(genome));
    }
}

TEST_CASE("every gene of space changes hash, equality and, but for effectors, the body",
          "[genome][hash]") {
    const std::vector<std::function<void(Genome&)>> changes = {
        [](Genome& g) { g.nodes[1].further[0].effector.weight += 1e-9; },
        [](Genome& g) { g.root_tilt += 1e-9; },
        [](Genome& g) { g.root_roll += 1e-9; },
        [](Genome& g) { g.nodes[1].depth += 1e-9; },
        [](Genome& g) { g.nodes[1].further[0].limit_low -= 1e-9; },
        [](Genome& g) { g.nodes[1].further[0].limit_high += 1e-9; },
        [](Genome& g) { g.nodes[0].edges[0].height += 1e-9; },
        [](Genome& g) { g.nodes[0].edges[0].tilt += 1e-9; },
        [](Genome& g) { g.nodes[0].edges[0].roll += 1e-9; },
        [](Genome& g) { g.nodes[0].edges[0].reflect_depth ^= true; },
    };
    Genome genome = lifted(founder(), 0.0);
    genome.nodes[1].further.resize(2);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Genome other = genome;
        changes[i](other);
        INFO("change " << i);
        CHECK_FALSE(other == genome);
        CHECK(genome_hash(other) != genome_hash(genome));
        CHECK(differing_body_genes(genome, other) == (i == 0 ? 0 : 1));
    }
    Genome smaller = genome;
    smaller.nodes.pop_back();
    const NodeGene& last = genome.nodes.back();
    CHECK(differing_body_genes(genome, smaller) ==
          9 + static_cast<int>(2 * last.further.size() + last.edges.size()));
}

TEST_CASE("minus zero is the same gene as zero", "[genome][hash]") {
    Genome genome = founder();
    genome.root_angle = 0.0;
    Genome other = genome;
    other.root_angle = -0.0;
    CHECK(other == genome);
    CHECK(genome_hash(other) == genome_hash(genome));
}
