// Organs in breeding: where they come from, that operators keep them valid, and that experiments
// without them draw the random numbers they drew before there were any.
#include "breeding/corpora.h"
#include "breeding/disconnected_neurons.h"
#include "breeding/gene_sites.h"
#include "support/build_speed.h"
#include "support/catch.h"

#include <algorithm>

using namespace cambrian;

namespace {

const FounderSettings& with_organs() {
    static const FounderSettings settings = [] {
        FounderSettings made;
        made.organs = {{"voice", true}, {"gland", true}, {"bender", true}};
        return made;
    }();
    return settings;
}

MutationContext organ_context() {
    return {full_catalog(), with_organs()};
}

std::size_t organ_count(const Genome& genome) {
    return organ_sites(genome).size();
}

MutationSettings only_operator(const std::string& id) {
    MutationSettings settings;
    const MutationRegistry all = builtin_mutations();
    for (const MutationKind& kind : all.all())
        settings.weights[kind.id] = kind.id == id ? 1.0 : 0.0;
    return settings;
}

std::vector<Genome> organ_corpus(std::size_t count) {
    std::vector<Genome> genomes;
    for (std::size_t i = 0; i < count; ++i) {
        RandomStream stream = test_stream(i);
        genomes.push_back(random_genome(with_organs(), full_catalog(), stream));
    }
    return genomes;
}

}  // namespace

TEST_CASE("founders have organs in 15 per cent of parts a kind, if a kind is enabled",
          "[breeding][organs]") {
    int parts = 0;
    int voices = 0;
    for (const Genome& genome : organ_corpus(600)) {
        parts += static_cast<int>(genome.nodes.size());
        for (const OrganGeneSite& site : organ_sites(genome))
            voices += genome.nodes[site.node].organs[site.organ].kind == 0 ? 1 : 0;
    }
    CHECK(voices == Approx(0.15 * parts).epsilon(0.15));
    for (const Genome& genome : founder_corpus(100))
        REQUIRE(organ_count(genome) == 0);
}

TEST_CASE("a hundred thousand operators keep genomes with organs valid", "[breeding][organs]") {
    const BreedingRegistry methods = builtin_breeding();
    const MutationRegistry mutations = builtin_mutations();
    std::vector<Genome> population = organ_corpus(60);
    RandomStream stream = test_stream(40);
    constexpr std::size_t most_operators = test::by_build(100'000, 4'000);
    std::size_t operators = 0;
    std::size_t most = 0;
    for (int i = 0; operators < most_operators; ++i) {
        const std::size_t method = stream.below(methods.size());
        Genome child = methods[method].breed(stream.pick(population), stream.pick(population),
                                             full_catalog(), stream);
        const MutationSettings settings{.rate = 6.0, .remove_disconnected_neurons = i % 4 == 0};
        operators += mutate(child, settings, mutations, organ_context(), stream).size();
        const auto complaints = validate(child, full_catalog());
        INFO(i << ": " << (complaints.empty() ? "" : complaints.front()));
        REQUIRE(complaints.empty());
        most = std::max(most, organ_count(child));
        stream.pick(population) = std::move(child);
    }
    CHECK(most > 6);
}

TEST_CASE("the operators of organs add, change and remove one", "[breeding][organs]") {
    const MutationRegistry mutations = builtin_mutations();
    RandomStream stream = test_stream(41);
    Genome genome = founder_corpus(1)[0];
    const auto apply = [&](const std::string& id) {
        MutationSettings settings = only_operator(id);
        settings.scheme = "none";
        const auto records = mutate(genome, settings, mutations, organ_context(), stream, 1);
        REQUIRE(records.size() == 1);
        CHECK(records[0].operator_id == id);
        return records[0];
    };
    const MutationRecord added = apply("add-organ");
    CHECK_THAT(added.to, Catch::StartsWith("new organ "));
    REQUIRE(organ_count(genome) == 1);
    const OrganGeneSite site = organ_sites(genome)[0];
    const OrganGene before = site.in(genome);
    const MutationRecord changed = apply("organ");
    CHECK_THAT(changed.place, Catch::StartsWith(site.in_words()));
    CHECK_FALSE(site.in(genome) == before);
    CHECK(site.in(genome).kind == before.kind);
    CHECK(apply("remove-organ").to == "removed");
    CHECK(organ_count(genome) == 0);
}

TEST_CASE("weights of organs' operators change no draw while no kind is enabled",
          "[breeding][organs]") {
    const MutationRegistry mutations = builtin_mutations();
    MutationSettings heavy;
    heavy.weights = {{"add-organ", 500.0}, {"organ", 500.0}, {"remove-organ", 500.0}};
    for (std::uint64_t number = 0; number < 200; ++number) {
        Genome plain = founder_corpus(1)[0];
        Genome weighted = plain;
        RandomStream first = test_stream(number);
        RandomStream second = test_stream(number);
        mutate(plain, {}, mutations, default_context(), first);
        mutate(weighted, heavy, mutations, default_context(), second);
        REQUIRE(plain == weighted);
        REQUIRE(first.bits() == second.bits());
    }
}

TEST_CASE("grafting carries the organs of the grafted parts along", "[breeding][organs]") {
    Genome first = founder_corpus(1)[0];
    Genome second = founder_corpus(2)[1];
    for (NodeGene& node : second.nodes)
        node.organs = {{.kind = 0, .parameters = {2.0}}, {.kind = 1}};
    const BreedingRegistry methods = builtin_breeding();
    for (const char* id : {"grafting", "crossover"}) {
        RandomStream stream = test_stream(42);
        std::size_t carried = 0;
        for (int i = 0; i < 50; ++i) {
            const Genome child = methods.find(id)->breed(first, second, full_catalog(), stream);
            for (const NodeGene& node : child.nodes) {
                const bool complete = node.organs.empty() || node.organs == second.nodes[0].organs;
                REQUIRE(complete);
                carried += node.organs.size();
            }
        }
        INFO(id);
        CHECK(carried > 0);
    }
}

TEST_CASE("a neuron that only an organ hears is kept, and removal reconnects the organ",
          "[breeding][organs]") {
    const auto absolute = static_cast<std::uint8_t>(
        std::find_if(full_catalog().functions.begin(), full_catalog().functions.end(),
                     [](const FunctionEntry& each) { return each.id == "abs"; }) -
        full_catalog().functions.begin());
    Genome genome;
    genome.nodes.resize(1);
    NodeGene& root = genome.nodes[0];
    const SourceRef touch{SourceKind::kLocalSensor, 1};
    root.neurons = {{absolute, {{}}}, {absolute, {{touch, 1.0}}}};
    root.organs = {{.kind = 1, .input = {own_neuron(SourceScope::kPart, 1), 1.0}}};
    remove_disconnected_neurons(genome);
    REQUIRE(genome.nodes[0].neurons.size() == 1);
    CHECK(genome.nodes[0].organs[0].input.source == own_neuron(SourceScope::kPart, 0));

    RandomStream stream = test_stream(43);
    MutationSettings settings = only_operator("remove-neuron");
    settings.scheme = "none";
    mutate(genome, settings, builtin_mutations(), organ_context(), stream, 1);
    CHECK(genome.nodes[0].neurons.empty());
    CHECK(genome.nodes[0].organs[0].input.source == touch);
}
