// Founders and their mutated descendants hold only references of the kinds the settings allow.

#include "breeding/corpora.h"
#include "breeding/gene_sites.h"
#include "genome/founders/enabled_kinds.h"
#include "support/build_speed.h"
#include "support/catch.h"

#include <algorithm>
#include <set>

using namespace cambrian;

namespace {

FounderSettings only(const std::set<SourceKind>& kinds) {
    FounderSettings settings;
    settings.max_node_neurons = 4;
    settings.max_brain_neurons = 4;
    for (std::size_t i = 0; i < source_rules().size(); ++i)
        settings.references[std::string(source_rules()[i].id)] = kinds.contains(SourceKind(i));
    return settings;
}

// Returns random settings under which parts and the brain each have something to read.
FounderSettings random_settings(RandomStream& stream) {
    const KindCatalog& catalog = full_catalog();
    while (true) {
        std::set<SourceKind> kinds;
        for (int i = 0; i < kSourceKindCount; ++i) {
            if (stream.chance(0.4)) kinds.insert(SourceKind(i));
        }
        FounderSettings settings = only(kinds);
        if (!enabled_references(SourceScope::kPart, settings, catalog).empty() &&
            !enabled_references(SourceScope::kBrain, settings, catalog).empty()) {
            return settings;
        }
    }
}

// Adds the kinds of all references to a set.
void collect(Genome genome, std::set<SourceKind>& seen) {
    for (const InputSite& site : input_sites(genome))
        seen.insert(site.in(genome).source.kind);
}

std::set<SourceKind> kinds_in_lineage(const FounderSettings& settings, int mutations,
                                      RandomStream& stream) {
    const MutationRegistry operators = builtin_mutations();
    std::set<SourceKind> seen;
    Genome genome = random_genome(settings, full_catalog(), stream);
    collect(genome, seen);
    for (int i = 0; i < mutations; ++i) {
        mutate(genome, {.rate = 2.0}, operators, {full_catalog(), settings}, stream);
        REQUIRE(validate(genome, full_catalog()).empty());
        collect(genome, seen);
    }
    return seen;
}

}  // namespace

TEST_CASE("founders and mutations never draw a kind of reference that is forbidden",
          "[breeding][references]") {
    RandomStream stream = test_stream(90);
    std::set<SourceKind> ever;
    for (int lineage = 0; lineage < test::by_build(1500, 150); ++lineage) {
        const FounderSettings settings = random_settings(stream);
        for (const SourceKind kind : kinds_in_lineage(settings, 12, stream)) {
            const std::string id(source_rule(kind).id);
            INFO("lineage " << lineage << ": " << id);
            REQUIRE(settings.references.at(id));
            ever.insert(kind);
        }
    }
    CHECK(ever.size() == kSourceKindCount);
}

TEST_CASE("every kind of reference is drawn if it is the only one of its scope",
          "[breeding][references]") {
    for (std::size_t i = 0; i < source_rules().size(); ++i) {
        const auto kind = SourceKind(i);
        const bool of_parts = is_allowed(kind, SourceScope::kPart);
        const auto other = of_parts ? SourceKind::kPartNeuron : SourceKind::kLocalNeuron;
        RandomStream stream = test_stream(91);
        std::set<SourceKind> seen;
        for (int lineage = 0; lineage < 20; ++lineage)
            seen.merge(kinds_in_lineage(only({kind, other}), 5, stream));
        INFO(source_rules()[i].id);
        CHECK(seen == std::set<SourceKind>{kind, other});
    }
}

TEST_CASE("switches that are all on draw what no switches draw", "[breeding][references]") {
    std::set<SourceKind> all;
    for (int i = 0; i < kSourceKindCount; ++i)
        all.insert(SourceKind(i));
    FounderSettings switched;
    switched.references = only(all).references;
    for (std::uint64_t number = 0; number < 200; ++number) {
        RandomStream with = test_stream(number);
        RandomStream without = test_stream(number);
        Genome a = random_genome(switched, full_catalog(), with);
        Genome b = random_genome({}, full_catalog(), without);
        mutate(a, {.rate = 4.0}, builtin_mutations(), {full_catalog(), switched}, with);
        mutate(b, {.rate = 4.0}, builtin_mutations(), default_context(), without);
        REQUIRE(a == b);
        REQUIRE(with.bits() == without.bits());
    }
}

TEST_CASE("a neuron that hears itself is removed without a constant where none are allowed",
          "[breeding][references]") {
    Genome genome;
    genome.nodes.resize(1);
    const SourceRef itself{.kind = SourceKind::kLocalNeuron, .index = 0};
    genome.nodes[0].neurons = {{.function = 0, .inputs = {{itself}, {itself}, {itself}}}};
    genome.nodes[0].effector.source = itself;
    const FounderSettings settings = only({SourceKind::kParentSensor, SourceKind::kBrainNeuron});
    RandomStream stream = test_stream(92);
    MutationRecord record;
    const MutationRegistry operators = builtin_mutations();
    REQUIRE(
        operators.find("remove-neuron")->apply(genome, {full_catalog(), settings}, stream, record));
    CHECK(genome.nodes[0].neurons.empty());
    const SourceKind left = genome.nodes[0].effector.source.kind;
    CHECK((left == SourceKind::kParentSensor || left == SourceKind::kBrainNeuron));
}
