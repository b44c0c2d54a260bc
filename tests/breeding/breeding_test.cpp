// The tests of breeding/README.md 6. Nodes are identified by uid, which breeding copies.

#include "breeding/corpora.h"
#include "breeding/methods.h"
#include "support/catch.h"

#include <set>

using namespace cambrian;

namespace {

const BreedingRegistry& methods() {
    static const BreedingRegistry all = builtin_breeding();
    return all;
}

Genome breed(const std::string& method, const Genome& first, const Genome& second,
             std::uint64_t number) {
    RandomStream stream = test_stream(number);
    return methods().find(method)->breed(first, second, full_catalog(), stream);
}

std::set<std::uint32_t> uids(const Genome& genome) {
    std::set<std::uint32_t> all;
    for (const NodeGene& node : genome.nodes)
        all.insert(node.uid);
    return all;
}

bool has_nodes_of(const Genome& child, const Genome& parent) {
    const std::set<std::uint32_t> known = uids(parent);
    return std::any_of(child.nodes.begin(), child.nodes.end(),
                       [&](const NodeGene& node) { return known.count(node.uid) > 0; });
}

std::vector<Genome> with_three_nodes(std::vector<Genome> corpus) {
    std::erase_if(corpus, [](const Genome& genome) { return genome.nodes.size() < 3; });
    return corpus;
}

// Returns the share of children with nodes of both parents.
double mixed_share(const std::string& method, const std::vector<Genome>& corpus) {
    constexpr std::size_t pairs = 1000;
    RandomStream stream = test_stream(31);
    double mixed = 0.0;
    for (std::size_t i = 0; i < pairs; ++i) {
        const std::size_t first = stream.below(corpus.size());
        const std::size_t second = (first + 1 + stream.below(corpus.size() - 1)) % corpus.size();
        const Genome child = breed(method, corpus[first], corpus[second], i);
        mixed += has_nodes_of(child, corpus[first]) && has_nodes_of(child, corpus[second]);
    }
    return mixed / pairs;
}

}  // namespace

TEST_CASE("every method makes a valid child, leaves its parents alone and repeats itself",
          "[breeding]") {
    std::vector<Genome> corpus = founder_corpus(40);
    for (const Genome& genome : evolved_corpus(20))
        corpus.push_back(genome);
    for (const Genome& genome : single_part_corpus(10))
        corpus.push_back(genome);
    const std::vector<Genome> before = corpus;
    for (const BreedingKind& method : methods().all()) {
        for (std::uint64_t i = 0; i < 1500; ++i) {
            RandomStream stream = test_stream(i);
            const Genome& first = stream.pick(corpus);
            const Genome& second = stream.pick(corpus);
            const Genome child = breed(method.id, first, second, i);
            const auto complaints = validate(child, full_catalog());
            INFO(method.id << " " << i << ": " << (complaints.empty() ? "" : complaints.front()));
            REQUIRE(complaints.empty());
            REQUIRE(breed(method.id, first, second, i) == child);
        }
    }
    CHECK(corpus == before);
}

TEST_CASE("the default shares are 40, 30 and 30 per cent", "[breeding]") {
    CHECK(methods().find("asexual")->default_share == 0.4);
    CHECK(methods().find("crossover")->default_share == 0.3);
    CHECK(methods().find("grafting")->default_share == 0.3);
}

TEST_CASE("genes name the heritable methods, in an order that digests count", "[breeding]") {
    const std::vector<std::string> named = {"inherit", "asexual", "crossover", "grafting"};
    CHECK(reproductions_of(methods()) == named);
    BreedingRegistry more = methods();
    more.add({.id = "budding", .label = "Budding", .parents = 1});
    CHECK(reproductions_of(more).back() == "budding");
    CHECK(single_parent_method(more).id == "asexual");
}

TEST_CASE("an asexual child is a nameless copy", "[breeding]") {
    Genome parent = founder_corpus(1)[0];
    parent.name = "Adam";
    const Genome child = breed("asexual", parent, parent, 1);
    CHECK(child == parent);
    CHECK(child.hue == parent.hue);
    CHECK(child.name.empty());
}

TEST_CASE("most crossover children have nodes of both parents", "[breeding][crossover]") {
    CHECK(mixed_share("crossover", with_three_nodes(founder_corpus(300))) >= 0.7);
    CHECK(mixed_share("crossover", with_three_nodes(evolved_corpus(60, 30))) >= 0.7);
}

TEST_CASE("crossover changes parents once, twice or three times by .6, .3 and .1",
          "[breeding][crossover]") {
    RandomStream stream = test_stream(32);
    std::array<double, 4> seen{};
    for (int i = 0; i < 20000; ++i)
        seen[draw_switch_points(8, stream).size()] += 1.0 / 20000;
    CHECK(seen[0] == 0.0);
    CHECK(seen[1] == Approx(0.6).margin(0.015));
    CHECK(seen[2] == Approx(0.3).margin(0.015));
    CHECK(seen[3] == Approx(0.1).margin(0.015));
}

TEST_CASE("crossover's switch points lie after the root, in order", "[breeding][crossover]") {
    RandomStream stream = test_stream(33);
    for (int i = 0; i < 1000; ++i) {
        const auto points = draw_switch_points(3, stream);
        REQUIRE(std::set(points.begin(), points.end()).size() == points.size());
        REQUIRE(std::is_sorted(points.begin(), points.end()));
        REQUIRE(points.front() >= 1);
        REQUIRE(points.back() <= 2);
    }
    CHECK(draw_switch_points(1, stream).empty());
}

TEST_CASE("almost all grafted children have nodes of both parents", "[breeding][grafting]") {
    CHECK(mixed_share("grafting", founder_corpus(300)) >= 0.99);
    CHECK(mixed_share("grafting", evolved_corpus(60, 30)) >= 0.99);
}

TEST_CASE("a graft replaces one edge's target and keeps its place", "[breeding][grafting]") {
    Genome body;
    body.nodes.resize(2);
    body.nodes[0].edges = {{.target = 1, .position = 0.4, .angle = 0.2}};
    body.nodes[1].uid = 1;
    Genome donor;
    donor.nodes.resize(1);
    donor.nodes[0].uid = 9;
    const Genome child = breed("grafting", body, donor, 1);
    REQUIRE(child.nodes.size() == 2);
    CHECK(child.nodes[1].uid == 9);
    CHECK(child.nodes[0].edges[0] == body.nodes[0].edges[0]);
}

TEST_CASE("a graft onto a single part gives it an edge", "[breeding][grafting]") {
    const std::vector<Genome> donors = founder_corpus(20);
    Genome single;
    single.nodes.resize(1);
    for (std::uint64_t i = 0; i < donors.size(); ++i)
        CHECK(breed("grafting", single, donors[i], i).nodes[0].edges.size() == 1);
}

TEST_CASE("homologous crossover takes corresponding genes from any place", "[breeding]") {
    // The parents have the same three limbs on one body, in different orders.
    Genome first = founder_corpus(1)[0];
    NodeGene body = first.nodes[0];
    body.edges.clear();
    body.uid = 1;
    first.nodes = {body};
    for (std::uint32_t limb = 0; limb < 3; ++limb) {
        NodeGene node = body;
        node.uid = 10 + limb;
        node.length = 0.3 + 0.1 * limb;
        first.nodes[0].edges.push_back({.target = static_cast<std::uint8_t>(1 + limb)});
        first.nodes.push_back(node);
    }
    Genome second = first;
    std::rotate(second.nodes.begin() + 1, second.nodes.begin() + 2, second.nodes.end());
    REQUIRE(validate(first, full_catalog()).empty());
    REQUIRE(validate(second, full_catalog()).empty());
    int mixed_up = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
        CHECK(uids(breed("homologous-crossover", first, second, i)).size() == 4);
        mixed_up += uids(breed("crossover", first, second, i)).size() < 4 ? 1 : 0;
    }
    CHECK(mixed_up > 50);  // alignment by position duplicates a limb
}
