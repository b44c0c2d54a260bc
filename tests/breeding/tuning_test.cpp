// The tests of breeding/README.md 9.
#include "breeding/mutations/tuning.h"

#include "breeding/corpora.h"
#include "genome/gene_fields.h"
#include "math/elementary.h"
#include "support/catch.h"

#include <cmath>
#include <set>

using namespace cambrian;

namespace {

Genome tuned(const Genome& genome, std::uint64_t number) {
    Genome child = genome;
    RandomStream stream = test_stream(number);
    tune(child, nullptr, full_catalog(), stream);
    return child;
}

// Returns the genome with all numbers of nodes, edges and links equal.
Genome leveled(Genome genome) {
    const auto level = [](NeuronGene& neuron) {
        for (InputGene& input : neuron.inputs)
            input.weight = 1.0;
    };
    genome.root_angle = 0.0;
    std::for_each(genome.brain.begin(), genome.brain.end(), level);
    for (NodeGene& node : genome.nodes) {
        for (const GeneField<NodeGene>& field : node_fields(2))
            node.*field.value = field.rule.fallback;
        for (EdgeGene& edge : node.edges) {
            for (const GeneField<EdgeGene>& field : edge_fields(2))
                edge.*field.value = field.rule.fallback;
        }
        node.effector.weight = 1.0;
        std::for_each(node.neurons.begin(), node.neurons.end(), level);
    }
    return genome;
}

}  // namespace

TEST_CASE("tuning changes numbers but no structure", "[breeding][tuning]") {
    std::uint64_t number = 0;
    std::size_t changed = 0;
    const std::vector<Genome> corpus = evolved_corpus(200, 20);
    for (const Genome& genome : corpus) {
        const Genome child = tuned(genome, ++number);
        REQUIRE(validate(child, full_catalog()).empty());
        CHECK(leveled(child) == leveled(genome));
        changed += child == genome ? 0U : 1U;
    }
    CHECK(changed == corpus.size());
}

TEST_CASE("the same stream tunes in the same way, another one in another", "[breeding][tuning]") {
    const Genome genome = founder_corpus(1)[0];
    CHECK(tuned(genome, 1) == tuned(genome, 1));
    CHECK_FALSE(tuned(genome, 1) == tuned(genome, 2));
}

TEST_CASE("half of the tuned genomes change in all numbers", "[breeding][tuning]") {
    const Genome genome = founder_corpus(1)[0];
    constexpr int kCount = 1000;
    int complete = 0;
    int announced = 0;
    for (std::uint64_t i = 0; i < kCount; ++i) {
        Genome child = genome;
        RandomStream stream = test_stream(i);
        announced += tune(child, nullptr, full_catalog(), stream).place == "all numbers" ? 1 : 0;
        bool all = true;
        for (std::size_t node = 0; node < genome.nodes.size(); ++node) {
            for (const GeneField<NodeGene>& field : node_fields(2))
                all = all && child.nodes[node].*field.value != genome.nodes[node].*field.value;
        }
        complete += all ? 1 : 0;
    }
    // The standard deviation of a share of one half is 0.016.
    CHECK(complete == Approx(0.5 * kCount).margin(80));
    CHECK(complete - announced < 20);
    CHECK(complete >= announced);
}

TEST_CASE("steps of tuning reach from fine ones to those of mutations", "[breeding][tuning]") {
    Genome genome;
    genome.nodes.resize(1);
    genome.nodes[0].length = 0.5;
    int fine = 0;
    int coarse = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const double step = std::fabs(tuned(genome, i).nodes[0].length - 0.5);
        fine += step > 0.0 && step < 0.01 ? 1 : 0;
        coarse += step > 0.1 ? 1 : 0;
        CHECK(step <= 0.35);  // gauss() is at most 3.47, the step of lengths a fifth of 0.5 m
    }
    CHECK(fine > 100);
    CHECK(coarse > 20);
}

TEST_CASE("equal numbers of one kind stay equal, so a common frequency stays common",
          "[breeding][tuning]") {
    FounderSettings settings;
    settings.rhythmic_share = 1.0;
    settings.min_nodes = 3;
    std::uint64_t number = 0;
    for (int i = 0; i < 50; ++i) {
        RandomStream stream = test_stream(++number);
        Genome genome = random_genome(settings, full_catalog(), stream);
        for (int generation = 0; generation < 20; ++generation)
            genome = tuned(genome, ++number);
        std::set<double> frequencies;
        for (const NodeGene& node : genome.nodes)
            frequencies.insert(node.neurons.back().inputs[0].weight);
        CHECK(frequencies.size() == 1);
    }
}

TEST_CASE("three tenths of tuned genomes repeat the step from their mother, some of them only that",
          "[breeding][tuning]") {
    Genome before;
    before.nodes.resize(1);
    before.nodes[0].length = 0.5;
    before.nodes[0].width = 0.3;
    before.root_angle = 3.0;
    Genome genome = before;
    genome.nodes[0].length = 0.52;
    genome.nodes[0].width = 0.29;
    genome.root_angle = -3.0;  // 0.28 rad onwards
    constexpr int kCount = 2000;
    int repeated = 0;
    int only = 0;
    for (std::uint64_t i = 0; i < kCount; ++i) {
        Genome child = genome;
        RandomStream stream = test_stream(i);
        const std::string step = tune(child, &before, full_catalog(), stream).to;
        REQUIRE(validate(child, full_catalog()).empty());
        repeated += step.find("last step") != std::string::npos ? 1 : 0;
        if (step.find("steps of") != std::string::npos) continue;
        ++only;
        CHECK(child.nodes[0].limit_low == genome.nodes[0].limit_low);
        const double factor = (child.nodes[0].length - 0.52) / 0.02;
        CHECK(child.nodes[0].width == Approx(0.29 - 0.01 * factor).margin(1e-9));
        CHECK(factor >= 0.3);
        CHECK(factor <= 2.0);
        const double turn = 2.0 * kPi - 6.0;
        CHECK(child.root_angle == Approx(-3.0 + turn * factor).margin(1e-9));
    }
    // The standard deviations of these counts are 20 and 16.
    CHECK(repeated == Approx(0.3 * kCount).margin(100));
    CHECK(only == Approx(0.15 * kCount).margin(80));
}

TEST_CASE("no step is repeated from a mother of another structure", "[breeding][tuning]") {
    const std::vector<Genome> corpus = founder_corpus(2);
    for (std::uint64_t i = 0; i < 200; ++i) {
        Genome child = corpus[0];
        RandomStream stream = test_stream(i);
        const MutationRecord record = tune(child, &corpus[1], full_catalog(), stream);
        CHECK(record.to.find("last step") == std::string::npos);
        CHECK(leveled(child) == leveled(corpus[0]));
    }
}
