#include "creature/body_plan_hash.h"

#include "core/hash.h"

#include <algorithm>
#include <vector>

namespace cambrian {
namespace {

constexpr std::uint64_t kDeforms = 0xDEF0;

}  // namespace

// The hash of a part covers its joint and the sorted hashes of its children. A parent comes before
// its children, so a loop from the end knows all children of a part.
std::uint64_t body_plan_hash(const Phenotype& phenotype) {
    const std::vector<PlannedPart>& parts = phenotype.plan.parts;
    std::vector<std::vector<std::uint64_t>> children(parts.size());
    std::uint64_t root = 0;
    for (std::size_t i = parts.size(); i-- > 0;) {
        const bool is_root = parts[i].parent < 0;
        std::sort(children[i].begin(), children[i].end());
        Hash64 hash;
        hash.add(std::uint64_t{is_root ? 0U : 1U + static_cast<unsigned>(parts[i].motion)});
        hash.add(std::uint64_t{children[i].size()});
        for (const std::uint64_t child : children[i])
            hash.add(child);
        // Rigid parts keep the hash that they had before any part could deform.
        if (parts[i].stretch) hash.add(kDeforms);
        if (!is_root && parts[i].half_extents.z() > 0.0) {
            for (std::size_t degree = 0; degree < degrees_of(parts[i]); ++degree)
                hash.add(std::uint64_t{parts[i].axes[degree]});
        }
        if (is_root) {
            root = hash.value();
        } else {
            children[static_cast<std::size_t>(parts[i].parent)].push_back(hash.value());
        }
    }
    return root;
}

}  // namespace cambrian
