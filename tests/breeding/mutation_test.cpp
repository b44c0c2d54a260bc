#include "breeding/corpora.h"
#include "support/build_speed.h"
#include "support/catch.h"

#include <map>

using namespace cambrian;

namespace {

const MutationRegistry& mutations() {
    static const MutationRegistry all = builtin_mutations();
    return all;
}

MutationSettings only(const std::string& id) {
    MutationSettings settings;
    for (const MutationKind& kind : mutations().all())
        settings.weights[kind.id] = kind.id == id ? 1.0 : 0.0;
    return settings;
}

}  // namespace

TEST_CASE("thousands of breedings and mutations in a row keep genomes valid and canonical",
          "[breeding][mutation]") {
    const BreedingRegistry methods = builtin_breeding();
    std::vector<Genome> population = founder_corpus(60);
    RandomStream stream = test_stream(6);
    for (int i = 0; i < test::by_build(15'000, 1'000); ++i) {
        const std::size_t method = stream.below(methods.size());
        Genome child = methods[method].breed(stream.pick(population), stream.pick(population),
                                             full_catalog(), stream);
        mutate(child, {.rate = 1.5}, mutations(), default_context(), stream);
        const auto complaints = validate(child, full_catalog());
        INFO(i << ": " << (complaints.empty() ? "" : complaints.front()));
        REQUIRE(complaints.empty());
        Genome repaired = child;
        repair(repaired, full_catalog());
        REQUIRE(repaired == child);
        stream.pick(population) = std::move(child);
    }
}

TEST_CASE("every operator can apply, changes the genome and says where", "[breeding][mutation]") {
    const std::vector<Genome> corpus = evolved_corpus(10);
    for (const MutationKind& kind : mutations().all()) {
        if (kind.enabled != nullptr) continue;  // organ_test.cpp
        INFO(kind.id);
        RandomStream stream = test_stream(7);
        int applied = 0;
        for (const Genome& parent : corpus) {
            Genome child = parent;
            for (const auto& record :
                 mutate(child, only(kind.id), mutations(), default_context(), stream)) {
                ++applied;
                CHECK(record.operator_id == kind.id);
                CHECK_FALSE(record.place.empty());
                CHECK_FALSE(record.to.empty());
                CHECK(record.from != record.to);
            }
        }
        CHECK(applied > 0);
    }
}

TEST_CASE("each operator's share of mutations follows its weight", "[breeding][mutation]") {
    const std::vector<Genome> corpus = evolved_corpus(10);
    std::map<std::string, int> seen;
    RandomStream stream = test_stream(8);
    int total = 0;
    for (std::size_t i = 0; i < 6000; ++i) {
        Genome child = corpus[i % corpus.size()];
        for (const auto& record : mutate(child, {}, mutations(), default_context(), stream)) {
            ++seen[record.operator_id];
            ++total;
        }
    }
    for (const MutationKind& kind : mutations().all()) {
        INFO(kind.id);
        if (kind.enabled != nullptr) {
            CHECK(seen[kind.id] == 0);
            continue;
        }
        // The weights add up to 110. Operators that cannot be applied are replaced by others.
        CHECK(seen[kind.id] == Approx(total * kind.default_weight / 110.0).epsilon(0.25));
    }
}

TEST_CASE("operators apply in the order of their phases", "[breeding][mutation]") {
    const std::vector<Genome> corpus = founder_corpus(20);
    RandomStream stream = test_stream(9);
    for (std::size_t i = 0; i < 2000; ++i) {
        Genome child = corpus[i % corpus.size()];
        const auto records = mutate(child, {.rate = 3.0}, mutations(), default_context(), stream);
        for (std::size_t r = 1; r < records.size(); ++r) {
            REQUIRE(mutations().find(records[r - 1].operator_id)->phase <=
                    mutations().find(records[r].operator_id)->phase);
        }
    }
}

TEST_CASE("disabled operators never apply, even where no other can", "[breeding][mutation]") {
    Genome genome = single_part_corpus(1)[0];
    genome.nodes[0].edges.clear();
    RandomStream stream = test_stream(10);
    for (int i = 0; i < 50; ++i)
        CHECK(mutate(genome, only("remove-edge"), mutations(), default_context(), stream).empty());
}

TEST_CASE("the same stream makes the same mutations", "[breeding][mutation]") {
    const Genome parent = founder_corpus(1)[0];
    Genome first = parent;
    Genome second = parent;
    RandomStream stream_a = test_stream(11);
    RandomStream stream_b = test_stream(11);
    for (int i = 0; i < 50; ++i) {
        mutate(first, {}, mutations(), default_context(), stream_a);
        mutate(second, {}, mutations(), default_context(), stream_b);
    }
    CHECK(first == second);
    CHECK_FALSE(first == parent);
}

TEST_CASE("a colour drifts with the number of mutations and wraps", "[breeding][mutation]") {
    Genome genome = founder_corpus(1)[0];
    genome.hue = 0.999;
    RandomStream stream = test_stream(12);
    const auto records = mutate(genome, {.rate = 4.0}, mutations(), default_context(), stream);
    const double hue = 0.999 + 0.004 * static_cast<double>(records.size());
    CHECK(genome.hue == Approx(hue - std::floor(hue)));
}

TEST_CASE("extra mutations come on top of those the scheme draws", "[breeding][mutation]") {
    const std::vector<Genome> corpus = founder_corpus(20);
    RandomStream stream = test_stream(15);
    double sum = 0.0;
    for (std::size_t i = 0; i < 2000; ++i) {
        Genome still = corpus[i % corpus.size()];
        const auto only_extra =
            mutate(still, {.scheme = "none"}, mutations(), default_context(), stream, 3);
        REQUIRE(only_extra.size() == 3);
        Genome child = corpus[i % corpus.size()];
        const auto records = mutate(child, {}, mutations(), default_context(), stream, 1);
        REQUIRE(records.size() >= 1);
        sum += static_cast<double>(records.size());
    }
    CHECK(sum / 2000 == Approx(2.125).margin(0.1));
}

TEST_CASE("joints change among the enabled ones only", "[breeding][mutation]") {
    Genome genome = founder_corpus(1)[0];
    RandomStream stream = test_stream(13);
    for (int i = 0; i < 500; ++i) {
        mutate(genome, only("node-discrete"), mutations(), default_context(), stream);
        for (const NodeGene& node : genome.nodes)
            REQUIRE(node.joint <= 1);
    }
}

TEST_CASE("the way of breeding mutates only where it is an attribute", "[breeding][mutation]") {
    const auto changes = [](bool is_attribute) {
        const MutationContext context = {full_catalog(), default_founders(), is_attribute};
        Genome genome = founder_corpus(1)[0];
        RandomStream stream = test_stream(14);
        bool changed = false;
        for (int i = 0; i < 100; ++i) {
            mutate(genome, only("node-discrete"), mutations(), context, stream);
            changed = changed || genome.reproduction != kNoOwnMethod;
        }
        return changed;
    };
    CHECK_FALSE(changes(false));
    CHECK(changes(true));
}
