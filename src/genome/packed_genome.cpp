#include "genome/packed_genome.h"

#include "core/assert.h"
#include "core/deflated_text.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

template <class Number>
void append_bits(std::string& bytes, Number number) {
    char bits[sizeof(Number)];
    std::memcpy(bits, &number, sizeof(Number));
    bytes.append(bits, sizeof(Number));
}

template <class Number>
void take_bits(std::string_view& bytes, Number& number) {
    CAMBRIAN_ASSERT(bytes.size() >= sizeof(Number), "a packed genotype has all its fields");
    std::memcpy(&number, bytes.data(), sizeof(Number));
    bytes.remove_prefix(sizeof(Number));
}

// Reals come after all other fields, since those compress better by themselves.
class GeneWriter {
public:
    void operator()(double real) { append_bits(reals_, real); }
    template <class Number>
    void operator()(Number number) {
        append_bits(others_, number);
    }
    template <class Items>
    void count(Items& items) {
        CAMBRIAN_ASSERT(items.size() <= std::numeric_limits<std::uint8_t>::max(),
                        "valid genomes have few genes");
        (*this)(static_cast<std::uint8_t>(items.size()));
    }
    std::string text() const {
        std::string text;
        append_bits(text, static_cast<std::uint32_t>(others_.size()));
        return text + others_ + reals_;
    }

private:
    std::string others_, reals_;
};

class GeneReader {
public:
    explicit GeneReader(std::string_view text) {
        std::uint32_t size = 0;
        take_bits(text, size);
        others_ = text.substr(0, size);
        reals_ = text.substr(size);
    }
    void operator()(double& real) { take_bits(reals_, real); }
    template <class Number>
    void operator()(Number& number) {
        take_bits(others_, number);
    }
    template <class Items>
    void count(Items& items) {
        std::uint8_t count = 0;
        (*this)(count);
        items.resize(count);
    }

private:
    std::string_view others_, reals_;
};

// The following visit all fields in the same order for writing and for reading.

template <class Items, class Bytes, class Visit>
void visit_all(Items& items, Bytes& bytes, Visit visit) {
    bytes.count(items);
    for (auto& item : items)
        visit(item, bytes);
}

template <class Input, class Bytes>
void visit_input(Input& input, Bytes& bytes) {
    bytes(input.source.kind);
    bytes(input.source.index);
    bytes(input.source.child);
    bytes(input.source.node);
    bytes(input.source.instance);
    bytes(input.weight);
}

template <class Neuron, class Bytes>
void visit_neuron(Neuron& neuron, Bytes& bytes) {
    bytes(neuron.function);
    visit_all(neuron.inputs, bytes, [](auto& input, auto& to) { visit_input(input, to); });
}

template <class Organ, class Bytes>
void visit_organ(Organ& organ, Bytes& bytes) {
    bytes(organ.kind);
    visit_input(organ.input, bytes);
    for (auto& parameter : organ.parameters)
        bytes(parameter);
}

template <class Edge, class Bytes>
void visit_edge(Edge& edge, Bytes& bytes) {
    bytes(edge.target);
    bytes(edge.position);
    bytes(edge.angle);
    bytes(edge.scale);
    bytes(edge.reflect);
    bytes(edge.terminal_only);
}

template <class Node, class Bytes>
void visit_node(Node& node, Bytes& bytes) {
    bytes(node.length);
    bytes(node.width);
    bytes(node.joint);
    bytes(node.limit_low);
    bytes(node.limit_high);
    bytes(node.recursion_limit);
    bytes(node.symmetric);
    bytes(node.mirror_axis);
    bytes(node.effector_kind);
    visit_input(node.effector, bytes);
    visit_all(node.organs, bytes, [](auto& organ, auto& to) { visit_organ(organ, to); });
    visit_all(node.neurons, bytes, [](auto& neuron, auto& to) { visit_neuron(neuron, to); });
    visit_all(node.edges, bytes, [](auto& edge, auto& to) { visit_edge(edge, to); });
    bytes(node.uid);
}

template <class AnyGenome, class Bytes>
void visit_genome(AnyGenome& genome, Bytes& bytes) {
    visit_all(genome.nodes, bytes, [](auto& node, auto& to) { visit_node(node, to); });
    visit_all(genome.brain, bytes, [](auto& neuron, auto& to) { visit_neuron(neuron, to); });
    bytes(genome.root_angle);
    bytes(genome.reproduction);
    bytes(genome.hue);
    visit_all(genome.name, bytes, [](auto& letter, auto& to) { to(letter); });
}

}  // namespace

PackedGenome::PackedGenome(const Genome& genome) {
    GeneWriter writer;
    visit_genome(genome, writer);
    const std::string text = writer.text();
    packed_ =
        std::make_shared<const Packed>(Packed{std::string(Deflater().deflate(text)), text.size()});
}

GenomePtr PackedGenome::unpack() const {
    if (empty()) return nullptr;
    const Result<std::string> text = Inflater().inflate(packed_->bytes, packed_->size);
    CAMBRIAN_ASSERT(text.has_value(), "bytes that were deflated");
    GeneReader reader(*text);
    Genome genome;
    visit_genome(genome, reader);
    return std::make_shared<const Genome>(std::move(genome));
}

}  // namespace cambrian
