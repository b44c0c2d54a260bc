#pragma once

#include "creature/phenotype.h"

#include <cstdint>
#include <map>
#include <memory>

namespace cambrian {

// Bodies of creatures that are shown small, grown when first needed, a few a frame. Of more than so
// many, the one that was not needed for longest goes.
class PhenotypeCache {
public:
    static constexpr std::size_t kMostKept = 600;

    // At most so many are grown until the next begin_frame().
    void begin_frame(int most_grown);
    // Null if its turn has not come yet.
    const Phenotype* find(const GenomePtr& genome, const Kinds& kinds,
                          const ExpressionSettings& expression, const SceneSettings& scene);
    void clear();
    std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        GenomePtr genome;  // keeps the key's address from being used again
        std::unique_ptr<const Phenotype> phenotype;
        std::uint64_t used = 0;  // when last, in calls of find()
    };
    void forget_oldest();

    std::map<const Genome*, Entry> entries_;
    std::map<std::uint64_t, const Genome*> by_use_;
    int may_grow_ = 0;
    std::uint64_t uses_ = 0;
};

}  // namespace cambrian
