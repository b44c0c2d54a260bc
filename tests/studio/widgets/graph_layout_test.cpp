#include "studio/widgets/graph_layout.h"

#include "studio/panels/inspector/brain_graph.h"
#include "studio/panels/inspector/genotype_tab.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>
#include <set>
#include <utility>

namespace cambrian {
namespace {

TEST_CASE("every node is below all nodes that lead to it", "[studio][graph_layout]") {
    const std::vector<GraphEdge> edges = {{0, 2}, {1, 2}, {2, 3}, {0, 3}, {3, 4}};
    const auto rows = graph_rows(5, edges);
    for (const GraphEdge& edge : edges)
        CHECK(rows[edge.from] < rows[edge.to]);
}

TEST_CASE("backward links do not move nodes down", "[studio][graph_layout]") {
    const auto rows = graph_rows(3, {{0, 1}, {1, 2}, {2, 0}, {1, 1}});
    CHECK(rows == std::vector<std::size_t>{0, 1, 2});
}

TEST_CASE("no two nodes share a place and all are inside", "[studio][graph_layout]") {
    const std::vector<std::size_t> rows = {0, 0, 0, 1, 1, 2, 2, 2, 2, 2, 2, 2};
    const auto points = place_in_rows(rows, {{0, 3}, {1, 4}, {3, 5}}, 4);
    std::set<std::pair<float, float>> taken;
    for (const GraphPoint& point : points) {
        CHECK((point.x > 0.0F && point.x < 1.0F && point.y > 0.0F && point.y < 1.0F));
        CHECK(taken.insert({point.x, point.y}).second);
    }
}

TEST_CASE("long rows are split", "[studio][graph_layout]") {
    const auto points = place_in_rows(std::vector<std::size_t>(10, 0), {}, 4);
    std::set<float> levels;
    for (const GraphPoint& point : points)
        levels.insert(point.y);
    CHECK(levels.size() == 3);
}

TEST_CASE("a brain's graph has every live neuron and every effector", "[studio][brain_graph]") {
    const auto genome = test::crawler(test::kinds().creature.catalog);
    const Phenotype phenotype = express(*genome, test::kinds().creature, {}, {});
    const BrainGraph graph = brain_graph(phenotype, test::kinds().creature, 6);
    const auto count = [&graph](BrainNodeKind kind) {
        return static_cast<std::size_t>(
            std::count_if(graph.nodes.begin(), graph.nodes.end(),
                          [kind](const BrainNode& node) { return node.kind == kind; }));
    };
    CHECK(count(BrainNodeKind::kNeuron) == phenotype.network.order.size());
    CHECK(count(BrainNodeKind::kEffector) == phenotype.effectors.size());
    CHECK(count(BrainNodeKind::kSensor) == phenotype.sensors.size());
    for (const BrainLink& link : graph.links)
        CHECK(std::max(link.edge.from, link.edge.to) < graph.nodes.size());
}

TEST_CASE("genes count their steps from the root, unreachable ones last", "[studio][genotype]") {
    Genome genome;
    genome.nodes.resize(4);
    genome.nodes[0].edges = {{.target = 2}};
    genome.nodes[2].edges = {{.target = 2}, {.target = 1}};
    CHECK(steps_from_root(genome) == std::vector<std::size_t>{0, 2, 1, 3});
}

}  // namespace
}  // namespace cambrian
