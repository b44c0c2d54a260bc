#include "preserve/life/lineage.h"

#include <algorithm>
#include <cstddef>

namespace cambrian {
namespace {

constexpr int kGenesOfAPart = 8;  // without edges

int differing(const NodeGene& a, const NodeGene& b) {
    const bool differ[] = {a.length != b.length,         a.width != b.width,
                           a.joint != b.joint,           a.limit_low != b.limit_low,
                           a.limit_high != b.limit_high, a.recursion_limit != b.recursion_limit,
                           a.symmetric != b.symmetric,   a.mirror_axis != b.mirror_axis};
    static_assert(std::size(differ) == kGenesOfAPart);
    int count = static_cast<int>(std::count(std::begin(differ), std::end(differ), true));
    const std::size_t both = std::min(a.edges.size(), b.edges.size());
    for (std::size_t i = 0; i < both; ++i)
        count += a.edges[i] == b.edges[i] ? 0 : 1;
    return count + static_cast<int>(std::max(a.edges.size(), b.edges.size()) - both);
}

}  // namespace

int differing_body_genes(const Genome& a, const Genome& b) {
    const std::size_t both = std::min(a.nodes.size(), b.nodes.size());
    int count = a.root_angle == b.root_angle ? 0 : 1;
    for (std::size_t i = 0; i < both; ++i)
        count += differing(a.nodes[i], b.nodes[i]);
    const Genome& larger = a.nodes.size() > b.nodes.size() ? a : b;
    for (std::size_t i = both; i < larger.nodes.size(); ++i)
        count += kGenesOfAPart + static_cast<int>(larger.nodes[i].edges.size());
    return count;
}

}  // namespace cambrian
