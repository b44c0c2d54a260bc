#include "genome/packed_genome.h"

#include "genome/random_garbage.h"
#include "genome/small_catalog.h"
#include "support/build_speed.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

// Returns a valid genome that sets every field.
Genome any_genome(RandomStream& stream, const KindCatalog& catalog) {
    Genome genome = garbage_genome(stream);
    for (NodeGene& node : genome.nodes) {
        node.effector_kind = garbage_byte(stream);
        node.uid = static_cast<std::uint32_t>(stream.below(1ULL << 32U));
    }
    repair(genome, catalog);
    return genome;
}

bool same_unexpressed_fields(const Genome& a, const Genome& b) {
    return a.hue == b.hue && a.name == b.name &&
           std::equal(
               a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
               [](const NodeGene& one, const NodeGene& other) { return one.uid == other.uid; });
}

}  // namespace

TEST_CASE("a packed genotype is unpacked with all its fields", "[genome][packed]") {
    const KindCatalog catalog = small_catalog();
    RandomStream stream(stream_seed(2, 0, 0, Purpose::kTest));
    for (int i = 0; i < test::by_build(3000, 500); ++i) {
        const Genome genome = any_genome(stream, catalog);
        const PackedGenome packed(genome);
        REQUIRE_FALSE(packed.empty());
        const GenomePtr unpacked = packed.unpack();
        REQUIRE(*unpacked == genome);
        REQUIRE(same_unexpressed_fields(*unpacked, genome));
    }
}

TEST_CASE("no genotype is unpacked as none", "[genome][packed]") {
    CHECK(PackedGenome().empty());
    CHECK(PackedGenome().unpack() == nullptr);
}
