#include "genome/genome.h"

#include "core/hash.h"
#include "genome/gene_fields.h"

#include <algorithm>
#include <type_traits>

namespace cambrian {
namespace {

// Adds the fields of genes either of the plane or of space, which come after all others, so that
// they changed no hash of the plane.
class GenomeHash {
public:
    template <class Gene>
    void add_fields(const Gene& gene, bool of_space) {
        visit_fields<Gene>([&](const auto& field) {
            if ((field.use == FieldUse::kBodyInSpace) != of_space) return;
            if (!field.later || gene.*field.value != decltype(gene.*field.value){})
                add(gene.*field.value);
        });
    }
    void add_space(const Genome& genome) {
        add_fields(genome, true);
        for (const NodeGene& node : genome.nodes) {
            add_fields(node, true);
            for (const EdgeGene& edge : node.edges)
                add_fields(edge, true);
        }
    }
    std::uint64_t value() const { return hash_.value(); }

private:
    // Adding 0 maps -0 to 0, since these are equal genes.
    void add(double number) { hash_.add(number + 0.0); }
    // Indices, flags and whole numbers are below 256.
    template <class Small>
    requires std::is_integral_v<Small> || std::is_enum_v<Small>
    void add(Small number) { hash_.add_byte(static_cast<std::uint8_t>(number)); }
    void add(const SourceRef& source) {
        add(source.kind);
        for (const auto number : {source.index, source.child, source.node, source.instance})
            add(number);
    }
    void add(const NeuronGene& neuron) {
        add(neuron.function);
        add(neuron.inputs);
    }
    template <class Gene>
    requires std::is_class_v<Gene>
    void add(const Gene& gene) { add_fields(gene, false); }
    template <class Gene>
    void add(const std::vector<Gene>& genes) {
        hash_.add(std::uint64_t{genes.size()});
        for (const Gene& gene : genes)
            add(gene);
    }
    void add(const std::vector<DegreeGene>& degrees) {
        for (const DegreeGene& degree : degrees)
            add(degree);
    }
    // A mark that no count of neurons has comes first, so that nodes without organs keep the hash
    // that they had before there were any.
    void add(const std::vector<OrganGene>& organs) {
        if (organs.empty()) return;
        constexpr std::size_t mark = 0x80;
        add(mark + organs.size());
        for (const OrganGene& organ : organs) {
            add(organ.kind);
            add(organ.input);
            for (const double parameter : organ.parameters)
                add(parameter);
        }
    }

    Hash64 hash_;
};

// Counts the fields of the body in which two genes differ; a gene that only one of two bodies has
// differs in all of them.
class BodyDifference {
public:
    explicit BodyDifference(int dimensions) : dimensions_(dimensions) {}

    template <class Gene>
    int of_fields(const Gene& a, const Gene* b) const {
        int count = 0;
        visit_fields<Gene>([&](const auto& field) {
            if (field.use == FieldUse::kControl || !field.is_of(dimensions_)) return;
            count += of_values(a.*field.value, b == nullptr ? nullptr : &(b->*field.value));
        });
        return count;
    }

private:
    template <class Value>
    int of_values(const Value& a, const Value* b) const {
        return b != nullptr && a == *b ? 0 : 1;
    }
    int of_values(const NodeGene& a, const NodeGene* b) const { return of_fields(a, b); }
    int of_values(const DegreeGene& a, const DegreeGene* b) const { return of_fields(a, b); }
    template <class Gene>
    int of_values(const std::vector<Gene>& a, const std::vector<Gene>* b) const {
        const std::size_t both = b == nullptr ? 0 : std::min(a.size(), b->size());
        const std::vector<Gene>& longer = b != nullptr && b->size() > a.size() ? *b : a;
        int count = 0;
        for (std::size_t i = 0; i < longer.size(); ++i) {
            const Gene* other = i < both ? &(*b)[i] : nullptr;
            count += of_values(i < both ? a[i] : longer[i], other);
        }
        return count;
    }

    int dimensions_;
};

template <class Gene>
bool same_fields(const Gene& a, const Gene& b) {
    bool same = true;
    visit_fields<Gene>([&](const auto& field) { same = same && a.*field.value == b.*field.value; });
    return same;
}

}  // namespace

bool operator==(const NodeGene& a, const NodeGene& b) {
    return same_fields(a, b);
}

bool operator==(const Genome& a, const Genome& b) {
    return a.dimensions == b.dimensions && same_fields(a, b);
}

std::uint64_t genome_hash(const Genome& genome) {
    GenomeHash hash;
    hash.add_fields(genome, false);
    if (genome.dimensions == 3) hash.add_space(genome);
    return hash.value();
}

int differing_body_genes(const Genome& a, const Genome& b) {
    return BodyDifference(a.dimensions).of_fields(a, &b);
}

Genome lifted(const Genome& planar, double depth) {
    Genome genome = planar;
    genome.dimensions = 3;
    for (NodeGene& node : genome.nodes)
        node.depth = depth > 0.0 ? depth : node.width;
    return genome;
}

}  // namespace cambrian
