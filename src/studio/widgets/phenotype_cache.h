#pragma once

#include "creature/phenotype.h"

#include <cstdint>
#include <map>
#include <memory>

namespace cambrian {

// Bodies of creatures that are displayed small. They are expressed when first needed, a few per
// frame. Beyond kMostKept, the least recently used one is removed.
class PhenotypeCache {
public:
    static constexpr std::size_t kMostKept = 600;

    // At most `most_grown` bodies are expressed until the next begin_frame().
    void begin_frame(int most_grown);
    // Returns null if the body is not expressed yet.
    const Phenotype* find(const GenomePtr& genome, const Kinds& kinds,
                          const ExpressionSettings& expression, const SceneSettings& scene);
    void clear();
    std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        GenomePtr genome;  // keeps the genome alive, since its address is the key
        std::unique_ptr<const Phenotype> phenotype;
        std::uint64_t used = 0;  // number of the last call of find() that used it
    };
    void forget_oldest();

    std::map<const Genome*, Entry> entries_;
    std::map<std::uint64_t, const Genome*> by_use_;
    int may_grow_ = 0;
    std::uint64_t uses_ = 0;
};

}  // namespace cambrian
