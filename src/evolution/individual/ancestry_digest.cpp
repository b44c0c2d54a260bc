#include "evolution/individual/ancestry_digest.h"

#include "core/hash.h"

namespace cambrian {

std::uint64_t ancestry_digest(const Individual& individual) {
    Hash64 digest;
    IndividualPtr ancestor;
    for (const Individual* each = &individual; each != nullptr;
         ancestor = each->mother.get(), each = ancestor.get()) {
        digest.add(each->uid);
        digest.add(std::uint64_t{each->born});
        for (const std::uint64_t parent : each->parents)
            digest.add(parent);
        digest.add(std::string_view(each->method));
        digest.add(each->genome_hash);
    }
    return digest.value();
}

}  // namespace cambrian
